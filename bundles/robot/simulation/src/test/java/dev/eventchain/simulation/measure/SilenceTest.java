package dev.eventchain.simulation.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.EventchainFactory;
import dev.eventchain.model.eventchain.LatencyConstraint;
import dev.eventchain.simulation.AebProject;
import dev.eventchain.simulation.SimulationResult;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests that a silent component is reported as untested, and not as software that lets a car crash.
 */
class SilenceTest {

  @TempDir Path folder;

  private SimulationResult simulate(Consumer<EventChain> change) throws Exception {
    return AebProject.of(folder, change)
        .simulate(List.of(AebProject.scenario("stopped-vehicle-50")));
  }

  /** Moves all data of a node on a topic to another one. */
  private static void move(List<Data> data, String from, String to) {
    data.stream()
        .filter(each -> each.getTopicName().equals(from))
        .forEach(each -> each.setTopicName(to));
  }

  private static String only(SimulationResult result) {
    assertEquals(
        List.of("simulation.node.silent"),
        result.diagnostics().stream().map(Diagnostic::id).toList());
    ScenarioVerdict verdict = result.verdicts().get(0);
    assertFalse(verdict.tested());
    assertFalse(verdict.passed());
    assertEquals(List.of(), verdict.diagnostics());
    assertFalse(result.passed());
    return result.diagnostics().get(0).message();
  }

  @Test
  void topicOfWhichEachMessageIsLostIsNoTopicThatNobodySends() throws Exception {
    Path file = folder.resolve("lost.yaml");
    Files.writeString(
        file,
        """
        name: lost
        title: Each scan is lost
        duration_s: 2
        ego: {speed_kmh: 50}
        inputs: {lidar.lost: 1}
        accept: {"no_impact": true}
        """);
    SimulationResult result =
        new AebProject(folder).simulate(List.of(Scenario.read(file, AebProject.BENCH)));
    String message = result.diagnostics().get(0).message();
    assertTrue(message.contains("no scenario let the bench send it"), message);
  }

  @Test
  void topicThatNobodySendsIsNamedOnceForAllThatWaitForIt() throws Exception {
    SimulationResult result =
        simulate(
            chain ->
                move(
                    chain.getSoftware().get(0).getInput(),
                    "/carla/ego_vehicle/lidar",
                    "/radar/objects"));
    assertEquals(
        "'ObjectDetection' never executed: /radar/objects never arrived: no component writes it,"
            + " and the simulated vehicle does not send it. Nor did 'TTC_Calculation',"
            + " 'Braking_Decision', 'Carla_Vehicle_Control'.",
        only(result));
  }

  @Test
  void vehicleThatIsNeverCommandedIsNoTestOfTheSoftware() throws Exception {
    SimulationResult result =
        simulate(
            chain ->
                move(
                    chain.getSoftware().get(3).getOutput(),
                    "/carla/ego_vehicle/vehicle_control_cmd",
                    "/somewhere/else"));
    assertEquals(
        "The vehicle was never commanded: "
            + "/carla/ego_vehicle/vehicle_control_cmd"
            + " never arrived: no component writes it.",
        only(result));
  }

  @Test
  void componentsThatWaitForEachOtherAreNamed() throws Exception {
    SimulationResult result =
        simulate(
            chain ->
                move(
                    chain.getSoftware().get(2).getInput(),
                    "/aeb/time_to_collision",
                    "/vehicle/brake_force"));
    assertEquals(
        "'Braking_Decision', 'Carla_Vehicle_Control' never executed: they wait for each other.",
        only(result));
  }

  @Test
  void everyLatencyConstraintIsMeasuredBetweenItsNodes() throws Exception {
    SimulationResult result =
        simulate(
            chain -> {
              constrain(chain, 0, 1);
              constrain(chain, 1, 2);
              constrain(chain, 0, 3);
              constrain(chain, 3, 0);
            });
    List<Double> medians =
        result.verdicts().get(0).latencies().stream()
            .map(found -> found.map(latency -> latency.statistics().median()).orElse(-1.0))
            .toList();
    assertEquals(-1.0, medians.get(3));
    assertTrue(medians.get(0) > 0 && medians.get(1) > 0, medians.toString());
    assertTrue(medians.get(2) > medians.get(0), medians.toString());
    assertEquals(
        result.verdicts().get(0).latency().orElseThrow(),
        result.verdicts().get(0).latencies().get(2).orElseThrow().statistics());
  }

  private static void constrain(EventChain chain, int first, int last) {
    LatencyConstraint constraint = EventchainFactory.eINSTANCE.createLatencyConstraint();
    constraint.setFirst(chain.getSoftware().get(first));
    constraint.setLast(chain.getSoftware().get(last));
    constraint.setMaximum(1);
    chain.getLatencyConstraints().add(constraint);
  }
}
