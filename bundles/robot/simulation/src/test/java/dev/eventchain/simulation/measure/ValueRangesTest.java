package dev.eventchain.simulation.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.model.Signal;
import dev.eventchain.sandbox.PythonEnvironment;
import dev.eventchain.simulation.AebProject;
import dev.eventchain.simulation.CaseSimulation;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.CaseResult;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that values outside of the ranges of their signals are found. */
class ValueRangesTest {

  private static final String COMMAND = "/carla/ego_vehicle/vehicle_control_cmd";
  private static final String STATUS = "/carla/ego_vehicle/vehicle_status";

  @TempDir Path folder;

  /** Gives a field the range from 0 to a number. */
  private static Signal limited(Signal signal, String topic, String path, double most) {
    Signal.Values values =
        new Signal.Values(OptionalDouble.of(0), OptionalDouble.of(most), List.of());
    List<Signal.Field> fields =
        signal.fields().stream()
            .map(
                field ->
                    signal.topic().equals(topic) && field.path().equals(path)
                        ? new Signal.Field(
                            path, field.type(), field.unit(), values, field.location())
                        : field)
            .toList();
    return new Signal(
        signal.topic(),
        signal.messageType(),
        signal.direction(),
        signal.qos(),
        fields,
        signal.location());
  }

  /** Returns the example's bench with these greatest values. */
  private static Bench bench(double brake, double speed) {
    return AebProject.bench(
        AebProject.declared().stream()
            .map(signal -> limited(signal, COMMAND, "brake", brake))
            .map(signal -> limited(signal, STATUS, "velocity", speed))
            .toList());
  }

  /** Returns the findings of an emergency braking with these greatest values. */
  private List<Diagnostic> found(double brake, double speed) throws Exception {
    AebProject project = new AebProject(folder.resolve(brake + " " + speed));
    return AebProject.simulate(
            project.request(
                List.of(AebProject.scenario("stopped-vehicle-50")), bench(brake, speed)))
        .diagnostics();
  }

  @Test
  void valuesWithinTheirRangesAreNotFound() throws Exception {
    assertEquals(List.of(), found(1.0, 60.0));
  }

  @Test
  void aCaseWithSuchAnOutputIsNotTested() throws Exception {
    Scenario scenario = AebProject.scenario("stopped-vehicle-50");
    List<Bench> benches = List.of(bench(1.0, 10.0), bench(0.5, 60.0));
    Map<Integer, CaseResult> results = new TreeMap<>();
    new CaseSimulation(
            new AebProject(folder).request(List.of(scenario), benches.get(0)),
            PythonEnvironment.ensure(line -> {}))
        .run(
            benches.size(),
            number -> new CaseSimulation.Case(scenario, benches.get(number)),
            results::put);
    assertEquals(CaseResult.Label.PASSED, results.get(0).label(), results.get(0)::reason);
    assertEquals(CaseResult.Label.UNTESTED, results.get(1).label());
    assertEquals("a value of " + COMMAND + " that its signal never has", results.get(1).reason());
  }

  @Test
  void limitsOfFloatsAreTheNearestOnes() {
    Signal.Values values =
        new Signal.Values(OptionalDouble.of(0), OptionalDouble.of(0.1), List.of("ON", "OFF"));
    assertTrue(values.hold(0.1f) && values.hold(0.1) && values.hold("OFF"));
    assertFalse(values.hold(Math.nextUp(0.1f)) || values.hold(Math.nextUp(0.1)));
    assertFalse(values.hold(Float.NaN) || values.hold(Double.NaN) || values.hold("OF"));
  }

  @Test
  void outputsAndInputsOutsideOfTheirRangesAreFound() throws Exception {
    List<Diagnostic> found = found(0.5, 10.0);
    assertEquals(
        List.of("simulation.input.range", "simulation.output.range"),
        found.stream().map(Diagnostic::id).sorted().toList());
    Diagnostic input = found.get(found.get(0).severity() == Severity.WARNING ? 0 : 1);
    Diagnostic output = found.get(found.get(0).severity() == Severity.WARNING ? 1 : 0);
    assertEquals(Severity.ERROR, output.severity());
    assertEquals("Carla_Vehicle_Control", output.location().element());
    assertTrue(output.message().contains("the software wrote '1.0' as 'brake' of " + COMMAND));
    assertTrue(output.message().contains(", but its signal goes from 0 to 0.5"), output.message());
    assertTrue(input.location().file().endsWith("carla.yaml"), input.location().file());
    assertTrue(input.message().contains("the simulated vehicle sent"), input.message());
  }
}
