package dev.eventchain.simulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.fixtures.InTurn;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.sandbox.PythonEnvironment;
import dev.eventchain.simulation.verdict.Measurements;
import dev.eventchain.simulation.verdict.MessageFlow;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests a component whose two inputs belong together: the scan, which has the stamp of the point
 * cloud it is made from and comes some 40 ms later, and the vehicle's status of that time.
 */
class SynchronizedInputsTest {

  private static final String STATUS = "/carla/ego_vehicle/vehicle_status";

  @TempDir Path folder;

  private AebProject project(OptionalDouble tolerance) throws Exception {
    return AebProject.of(
        folder.resolve("project" + tolerance),
        chain -> {
          SoftwareNode node = chain.getSoftware().get(1);
          Set<String> topics = Set.of("/scan", STATUS);
          node.getInput().stream()
              .filter(input -> topics.contains(input.getTopicName()))
              .forEach((Data input) -> node.getSynchronized().add(input));
          tolerance.ifPresent(node::setTolerance);
        });
  }

  private SimulationResult simulated(OptionalDouble tolerance) throws Exception {
    return project(tolerance).simulate(List.of(AebProject.scenario("stopped-vehicle-50")));
  }

  @Test
  void theSoftwareWorksWithWhatBelongsTogetherAndItsLatencyCountsTheWaiting() throws Exception {
    SimulationResult single =
        new AebProject(folder).simulate(List.of(AebProject.scenario("stopped-vehicle-50")));
    SimulationResult both = simulated(OptionalDouble.empty());
    assertEquals(List.of(), both.diagnostics());
    assertTrue(both.passed());
    assertTrue(age(both).minimum() > age(single).maximum(), age(both) + " " + age(single));
    assertTrue(read(both) > 20, () -> both.measurements().flow().toString());
  }

  private static Measurements.Statistics age(SimulationResult result) {
    return hop(result).age().orElseThrow();
  }

  private static long read(SimulationResult result) {
    return hop(result).samples().orElseThrow().read();
  }

  private static MessageFlow.Hop hop(SimulationResult result) {
    return result.measurements().flow().hops().stream()
        .filter(hop -> hop.reader().equals("TTC_Calculation") && hop.topic().equals(STATUS))
        .findFirst()
        .orElseThrow();
  }

  /** The scan is stamped 7 ms later than the vehicle's status that belongs to it. */
  private SimulationResult shifted(OptionalDouble tolerance) throws Exception {
    AebProject project = project(tolerance);
    Files.writeString(
        project.component("ObjectDetection"),
        """


        class ObjectDetection(ObjectDetection):
            def execute(self, **inputs):
                output = super().execute(**inputs)
                output["scan_stamp_nanosec"] = (output["scan_stamp_nanosec"] + 7_000_000) % 1_000_000_000
                return output
        """,
        StandardOpenOption.APPEND);
    return project.simulate(List.of(AebProject.scenario("stopped-vehicle-50")));
  }

  @Test
  void toleranceThatNoMessagesKeepToIsNotTested() throws Exception {
    for (OptionalDouble tolerance : List.of(OptionalDouble.of(7), OptionalDouble.empty())) {
      SimulationResult result = shifted(tolerance);
      assertFalse(result.passed());
      assertFalse(result.verdicts().get(0).tested());
      Diagnostic found = result.diagnostics().get(0);
      assertEquals("simulation.node.silent", found.id());
      assertEquals(
          "'TTC_Calculation' never executed: all of "
              + STATUS
              + ", /scan came, but never with "
              + (tolerance.isPresent()
                  ? "stamps that differ by less than the tolerance of 7.0 ms."
                  : "equal stamps.")
              + " Nor did 'Braking_Decision', 'Carla_Vehicle_Control'.",
          found.message());
    }
    assertTrue(shifted(OptionalDouble.of(7.5)).passed());
  }

  @InTurn
  @Test
  void onTheWireTheSameMessagesBelongTogether() throws Exception {
    SimulationRequest request =
        project(OptionalDouble.of(60)).request(List.of(AebProject.scenario("stopped-vehicle-50")));
    SimulationResult lockstep = AebProject.simulate(request);
    SimulationResult dds =
        Simulation.run(
            request.with(it -> it.withDriver(SimulationDriver.DDS)),
            PythonEnvironment.ensureWithCycloneDds(line -> {}),
            verdict -> {});
    assertEquals(List.of(), dds.diagnostics());
    assertEquals(lockstep.measurements().flow().hops(), dds.measurements().flow().hops());
  }
}
