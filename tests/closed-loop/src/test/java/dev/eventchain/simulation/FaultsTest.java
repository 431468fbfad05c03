package dev.eventchain.simulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.InTurn;
import dev.eventchain.sandbox.PythonEnvironment;
import dev.eventchain.simulation.fault.FaultPlan;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.FaultVerdict;
import dev.eventchain.simulation.verdict.FaultVerdict.Detection;
import dev.eventchain.simulation.verdict.FaultVerdict.Means;
import dev.eventchain.simulation.verdict.ScenarioVerdict.CriterionResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.ResourceLock;

/**
 * Tests faults in a drive towards a stopped vehicle, all in one simulation, since each run is slow.
 */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
@ResourceLock("processes of nodes")
class FaultsTest {

  private static final String FAULTS =
      """
      faults:
        - name: killed
          scenario: stopped-vehicle-50
          at_s: 2.03
          kill: Braking_Decision
          expect:
            detected_within_s: 0.4
            no_impact: true
        - name: between-messages
          scenario: stopped-vehicle-50
          at_s: 1.01
          for_s: 0.01
          drop: {topic: /carla/ego_vehicle/lidar}
          expect:
            detected: true
        - name: stopped
          scenario: stopped-vehicle-50
          at_s: 1
          for_s: 1.5
          stop: TTC_Calculation
          expect:
            detected: true
        - name: delayed
          scenario: stopped-vehicle-50
          at_s: 0
          delay: {node: ObjectDetection, ms: 20}
        - name: flooded
          scenario: stopped-vehicle-50
          at_s: 1
          for_s: 1
          flood: {node: ObjectDetection, times: 3}
        - name: dropped
          scenario: stopped-vehicle-50
          at_s: 1
          for_s: 1
          drop: {topic: /carla/ego_vehicle/lidar, percent: 50}
        - name: repeated
          scenario: stopped-vehicle-50
          at_s: 1
          for_s: 1
          repeat: {topic: /carla/ego_vehicle/lidar, times: 2}
          expect:
            formulas:
              - formula: always (gap > 1000 m implies ego.speed > 0 m/s)
        - name: corrupted
          scenario: stopped-vehicle-50
          at_s: 1
          corrupt: {topic: /carla/ego_vehicle/lidar}
        - name: corrupted-command
          scenario: stopped-vehicle-50
          at_s: 1
          corrupt: {topic: /carla/ego_vehicle/vehicle_control_cmd}
        - name: clock-forwards
          scenario: stopped-vehicle-50
          at_s: 1
          clock_jump_ms: 10000
          expect:
            detected_within_s: 0.1
        - name: sensor-dies
          scenario: stopped-vehicle-50
          at_s: 1
          dead_sensor: /carla/ego_vehicle/lidar
          expect:
            detected: true
      """;

  @TempDir static Path folder;

  private AebProject project;
  private SimulationResult result;
  private Map<String, FaultVerdict> faults;

  @BeforeAll
  void simulate() throws Exception {
    project = new AebProject(folder);
    result = AebProject.simulate(request(FAULTS));
    faults =
        result.faults().stream().collect(Collectors.toMap(FaultVerdict::name, Function.identity()));
  }

  private SimulationRequest request(String text) {
    return request(project, text);
  }

  private static SimulationRequest request(AebProject project, String text) {
    List<Scenario> scenarios = List.of(AebProject.scenario("stopped-vehicle-50"));
    FaultPlan plan =
        FaultPlan.parse(
            SourceText.of("faults.yaml", text), project.chain(), AebProject.BENCH, scenarios);
    return project.request(scenarios).with(it -> it.withFaults(plan));
  }

  private FaultVerdict fault(String name) {
    return faults.get(name);
  }

  private static List<String> found(FaultVerdict fault) {
    return fault.diagnostics().stream().map(it -> it.id() + " " + it.location().line()).toList();
  }

  @Test
  void whatIsMeasuredOfTheScenarioIsMeasuredWithoutFaults() throws Exception {
    List<Scenario> scenarios = List.of(AebProject.scenario("stopped-vehicle-50"));
    SimulationResult alone = AebProject.simulate(project.request(scenarios));
    assertTrue(result.passed());
    assertEquals(alone.measurements().runId(), result.measurements().runId());
    assertEquals(alone.diagnostics(), result.diagnostics());
  }

  @Test
  void theVehicleHitsTheOtherWhenWhoDecidesToBrakeIsKilled() {
    FaultVerdict killed = fault("killed");
    assertTrue(killed.vehicle().impactSpeed().isPresent());
    assertTrue(killed.without().impactSpeed().isEmpty());
    assertTrue(killed.deviation().distance() > 0);
    assertTrue(killed.judged() && killed.tested() && !killed.passed());
    assertEquals(List.of("simulation.fault.failed 8"), found(killed));
    CriterionResult noImpact = killed.own().get(0);
    assertEquals("no impact", noImpact.text());
    assertFalse(noImpact.passed());
  }

  @Test
  void whoWorksWithItsOutputDetectsIt() {
    Detection first = fault("killed").detections().get(0);
    assertEquals(Means.SOFTWARE, first.means());
    assertEquals("simulation.input.too-old", first.id());
    assertEquals("Carla_Vehicle_Control", first.element());
    assertEquals(2.03 + 0.25, first.time().orElseThrow(), 0.06);
  }

  @Test
  void aFaultThatMeetsNothingHasNoEffectAndNothingIsSaidOfTheSoftware() {
    FaultVerdict late = fault("between-messages");
    assertFalse(late.effective());
    assertFalse(late.tested());
    assertFalse(late.passed());
    assertEquals(List.of("simulation.fault.no-effect 9"), found(late));
  }

  @Test
  void aStoppedNodeGoesOn() {
    FaultVerdict stopped = fault("stopped");
    assertTrue(stopped.effective());
    assertTrue(stopped.passed());
    assertEquals("Braking_Decision", stopped.detections().get(0).element());
  }

  @Test
  void whatIsNotJudgedIsObserved() {
    FaultVerdict delayed = fault("delayed");
    assertFalse(delayed.judged());
    assertFalse(delayed.passed());
    assertEquals(List.of(), delayed.diagnostics());
    assertTrue(delayed.effect().endsWith(" activations took longer"), delayed::effect);
    assertEquals("20 messages arrived more than once", fault("flooded").effect());
    assertEquals("20 messages arrived more than once", fault("repeated").effect());
  }

  @Test
  void whatNeverCameUpIsNotTested() {
    FaultVerdict repeated = fault("repeated");
    assertFalse(repeated.tested());
    assertFalse(repeated.passed());
    assertEquals(List.of("simulation.fault.untested"), ids(repeated.diagnostics()));
  }

  @Test
  void aShareOfTheMessagesGetsLost() {
    String effect = fault("dropped").effect();
    int lost = Integer.parseInt(effect.substring(0, effect.indexOf(' ')));
    assertTrue(lost > 3 && lost < 17, effect);
  }

  @Test
  void aNodeThatFailsByCorruptMessagesIsPartOfTheResult() {
    for (String name : List.of("corrupted", "corrupted-command")) {
      FaultVerdict corrupted = fault(name);
      assertTrue(corrupted.effective(), name);
      assertTrue(corrupted.ended().isEmpty(), name);
      assertTrue(corrupted.vehicle().end() > 1, name);
    }
  }

  @Test
  void aJumpOfTheClockIsDetectedAtOnce() {
    FaultVerdict jump = fault("clock-forwards");
    assertTrue(jump.passed(), () -> jump.expected().toString());
    assertEquals(Means.SOFTWARE, jump.detections().get(0).means());
  }

  @Test
  void whatNothingTellsOfIsNotDetected() {
    FaultVerdict dead = fault("sensor-dies");
    assertFalse(dead.detected(), "the model states no age of what the world sends");
    assertEquals(List.of("simulation.fault.failed"), ids(dead.diagnostics()));
    assertTrue(dead.diagnostics().get(0).message().endsWith("but found: nothing reported it."));
  }

  @Test
  void ageThatTheModelStatesTellsOfADeadSensor() throws Exception {
    AebProject stating =
        AebProject.of(
            Files.createDirectory(folder.resolve("stating")),
            chain -> chain.getSoftware().get(0).getInput().forEach(it -> it.setMaximumAge(200)));
    String text = FAULTS.substring(FAULTS.indexOf("  - name: sensor-dies"));
    text = "faults:\n" + text.replace("detected: true", "detected_within_s: 0.1");
    FaultVerdict dead = AebProject.simulate(request(stating, text)).faults().get(0);
    assertEquals("ObjectDetection", dead.detections().get(0).element());
    assertEquals(List.of("simulation.fault.failed"), ids(dead.diagnostics()), "too late");
  }

  /**
   * The flood exceeds the limit of a scenario: the process ends, and the next fault gets another.
   */
  @InTurn
  @Test
  void aRunThatCannotGoOnIsPartOfTheResult() throws Exception {
    AebProject fast =
        AebProject.of(
            Files.createDirectory(folder.resolve("fast")),
            chain -> {
              chain.getSoftware().get(3).setFrequency(1000.0);
              chain.getSoftware().get(3).setWorstCaseExecutionTime(0.0);
            });
    String text =
        """
        faults:
          - name: too-much
            scenario: stopped-vehicle-50
            at_s: 0.2
            flood: {node: Carla_Vehicle_Control, times: 100}
            expect:
              detected: true
          - name: next
            scenario: stopped-vehicle-50
            at_s: 1
            kill: Braking_Decision
        """;
    SimulationResult result =
        AebProject.simulate(request(fast, text).with(it -> it.withProcesses(1)));
    FaultVerdict flooded = result.faults().get(0);
    assertEquals("simulation.limit", flooded.ended().orElseThrow().id());
    assertEquals(List.of("simulation.fault.untested"), ids(flooded.diagnostics()));
    assertFalse(flooded.tested());
    assertFalse(flooded.passed());
    assertEquals(List.of(), flooded.detections());
    assertTrue(flooded.vehicle().end() > 1 && flooded.vehicle().end() < 4);
    assertTrue(result.faults().get(1).ended().isEmpty());
    assertTrue(result.faults().get(1).vehicle().impactSpeed().isPresent());
  }

  private static List<String> ids(List<Diagnostic> found) {
    return found.stream().map(Diagnostic::id).toList();
  }

  @InTurn
  @Test
  void onDdsTheSameFaultsDoTheSame() throws Exception {
    List<FaultVerdict> wanted = new ArrayList<>();
    List<String> names = List.of("stopped", "clock-forwards");
    StringBuilder text = new StringBuilder("faults:\n");
    for (String part : FAULTS.split("(?=  - name: )", -1)) {
      if (names.stream().anyMatch(name -> part.startsWith("  - name: " + name + "\n"))) {
        text.append(part);
      }
    }
    names.forEach(name -> wanted.add(fault(name)));
    SimulationResult dds =
        Simulation.run(
            request(text.toString()).with(it -> it.withDriver(SimulationDriver.DDS)),
            PythonEnvironment.ensureWithCycloneDds(line -> {}),
            verdict -> {});
    assertEquals(wanted.size(), dds.faults().size());
    for (int i = 0; i < wanted.size(); i++) {
      assertEquals(measured(wanted.get(i)), measured(dds.faults().get(i)));
    }
  }

  /** Returns everything except the location in the file. */
  private static String measured(FaultVerdict fault) {
    return List.of(
            fault.name(),
            fault.effect(),
            fault.vehicle(),
            fault.deviation(),
            fault.detections(),
            fault.passed(),
            fault.own().stream().map(CriterionResult::measured).toList())
        .toString();
  }

  @Test
  void inRealTimeFaultsAreRefused() {
    SimulationRequest request =
        request(FAULTS).with(it -> it.withDriver(SimulationDriver.DDS_IN_REAL_TIME));
    DiagnosticException refused =
        assertThrows(DiagnosticException.class, () -> AebProject.simulate(request));
    assertEquals("fault.driver", refused.diagnostics().get(0).id());
    assertEquals(11, refused.diagnostics().size());
    assertEquals(2, refused.diagnostics().get(0).location().line());
  }
}
