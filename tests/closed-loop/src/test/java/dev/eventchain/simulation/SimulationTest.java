package dev.eventchain.simulation;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.fixtures.InTurn;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.model.eventchain.ComponentImplementation;
import dev.eventchain.sandbox.PythonEnvironment;
import dev.eventchain.simulation.node.NodeLimits;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.FieldSamples;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvFileSource;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests real nodes in a real confined process in the AEB example's scenarios. */
class SimulationTest {

  @TempDir Path folder;

  @Test
  void softwareThatFollowsTheRequirementsPassesEveryScenario() throws Exception {
    SimulationResult result = new AebProject(folder).simulate(AebProject.scenarios());
    assertEquals(
        List.of(),
        result.verdicts().stream().flatMap(verdict -> verdict.diagnostics().stream()).toList());
    assertTrue(result.passed());
    assertEquals(List.of(), result.diagnostics());
  }

  @Test
  void whatNodesReadAndWriteIsKeptMessageByMessageWhereItIsAskedFor() throws Exception {
    SimulationRequest request =
        new AebProject(folder).request(List.of(AebProject.scenario("stopped-vehicle-20")));
    ScenarioVerdict kept =
        AebProject.simulate(request.with(settings -> settings.withSamples(true))).verdicts().get(0);
    FieldSamples ranges = field(kept, "/scan", "ranges");
    assertEquals(FieldSamples.Form.ARRAY, ranges.form());
    FieldSamples.Sample last = ranges.samples().get(ranges.samples().size() - 1);
    assertTrue(last.size() == 181 && last.finite() > 0 && last.finite() < 181, last::toString);
    assertTrue(last.least() > 0 && last.least() < last.most(), last::toString);
    double period = last.time() - ranges.samples().get(ranges.samples().size() - 2).time();
    assertEquals(0.05, period, 1e-9);
    assertEquals(
        kept.flow().topics().stream()
            .filter(it -> it.name().equals("/scan"))
            .mapToLong(it -> it.published().getAsLong())
            .sum(),
        ranges.samples().size());
    assertEquals(
        FieldSamples.Form.NUMBER,
        field(kept, "/carla/ego_vehicle/vehicle_status", "velocity").form());
    assertEquals(List.of(), AebProject.simulate(request).verdicts().get(0).samples());
  }

  private static FieldSamples field(ScenarioVerdict verdict, String topic, String path) {
    return verdict.samples().stream()
        .filter(it -> it.topic().equals(topic) && it.path().equals(path))
        .findFirst()
        .orElseThrow();
  }

  @Test
  void formulasAreJudgedWithTheirMargins() throws Exception {
    String original =
        Files.readString(AebProject.EXAMPLE.resolve("scenarios/stopped-vehicle-50.yaml"));
    Path file = folder.resolve("formulas.yaml");
    Files.writeString(
        file,
        original.replaceFirst(
            "(?s)accept:.*",
            """
            accept:
              formulas:
                - name: keeps its speed first
                  formula: always[0,1] abs(ego.speed - 50 km/h) <= 5 km/h
                - formula: always ego.speed >= 10 km/h
            """));
    ScenarioVerdict verdict =
        new AebProject(folder)
            .simulate(List.of(Scenario.read(file, AebProject.BENCH)))
            .verdicts()
            .get(0);
    assertEquals(
        List.of(true, false),
        verdict.criteria().stream()
            .filter(each -> each.text().contains("ego.speed"))
            .map(ScenarioVerdict.CriterionResult::passed)
            .toList());
    Diagnostic finding = verdict.diagnostics().get(0);
    assertEquals(1, verdict.diagnostics().size());
    assertEquals("simulation.criterion.failed", finding.id());
    assertTrue(
        finding.message().contains("found: 'ego.speed >= 10 km/h' is missed by 10 km/h after "),
        finding.message());
    assertTrue(finding.location().line() > 0);
  }

  @ParameterizedTest
  @CsvSource({"-13, 60, 1", "-13, 50, 0"})
  void whoIsHitFromBehindIsToldWithoutACriterionAboutImpacts(double gap, double kmh, int hits)
      throws Exception {
    Path file = folder.resolve("follower.yaml");
    Files.writeString(
        file,
        """
        name: follower
        title: Another one follows
        requirements: [AEB-4]
        seed: 1
        duration_s: 6
        ego: {speed_kmh: 50}
        actors:
          - {gap_m: %s, speed_kmh: %s}
        accept:
          never_brakes: true
        """
            .formatted(gap, kmh));
    SimulationResult result =
        new AebProject(folder).simulate(List.of(Scenario.read(file, AebProject.BENCH)));
    List<Diagnostic> found = result.diagnostics();
    assertEquals(hits, found.size(), found::toString);
    for (Diagnostic each : found) {
      assertEquals("simulation.ego.hit-from-behind", each.id());
      assertEquals(Severity.WARNING, each.severity());
      assertEquals(file.toString(), each.location().file());
      assertTrue(each.message().contains(" hit the ego's rear at 10.0 km/h after "), each::message);
    }
  }

  @ParameterizedTest
  @CsvSource({
    "no_impact: true, 200, 250, 50, false",
    "minimal_gap_m: 5, 200, 250, 50, false",
    "maximal_impact_speed_kmh: 35, 100, 50, 50, false",
    "stops: true, 200, 0, 0, false",
    "no_impact: true, 60, 0, 50, true"
  })
  void howTheVehicleMovesIsTestedIfTheSoftwareChangesIt(
      String criterion, int gap, int actor, int driver, boolean tested) throws Exception {
    Path file = folder.resolve("merit.yaml");
    Files.writeString(
        file,
        """
        name: merit
        title: Who keeps the vehicle from an impact
        seed: 1
        duration_s: 10
        ego:
          speed_kmh: 50
          maneuvers: [{at_s: 0, speed_kmh: %s, acceleration_mps2: 4}]
        actors:
          - {gap_m: %s, speed_kmh: %s}
        accept: {"%s}
        """
            .formatted(driver, gap, actor, criterion.replace(": ", "\": ")));
    ScenarioVerdict verdict =
        new AebProject(folder)
            .simulate(List.of(Scenario.read(file, AebProject.BENCH)))
            .verdicts()
            .get(0);
    assertEquals(tested, verdict.passed(), () -> verdict.criteria().toString());
    assertEquals(tested, verdict.tested(), () -> verdict.criteria().toString());
    assertEquals(tested, !verdict.criteria().get(0).measured().contains("without any command"));
  }

  @Test
  void nodeThatIsNotSimulatedIsNamed() throws Exception {
    AebProject project = new AebProject(folder);
    project.chain().getSoftware().get(0).setImplementation(ComponentImplementation.NODE);
    SimulationResult result = project.simulate(List.of(AebProject.scenario("stopped-vehicle-50")));
    assertEquals(
        List.of("simulation.node.left-out", "simulation.node.silent"),
        result.diagnostics().stream().map(Diagnostic::id).sorted().toList());
    assertFalse(result.passed());
  }

  @ParameterizedTest
  @CsvFileSource(resources = "/failing.csv", numLinesToSkip = 1)
  void failingComponentIsNamedWithItsPlace(String file, String id, int line) throws Exception {
    AebProject project = new AebProject(folder).with("Braking_Decision", "failing/" + file);
    SimulationRequest request =
        project
            .request(List.of(AebProject.scenario("stopped-vehicle-50")))
            .with(
                it ->
                    it.withLimits(
                        new NodeLimits(
                            Duration.ofSeconds(1), Duration.ofMinutes(5), Duration.ofHours(1))));
    DiagnosticException failure =
        assertThrows(DiagnosticException.class, () -> AebProject.simulate(request));
    assertEquals(DiagnosticException.Reason.FINDINGS, failure.reason());
    Diagnostic finding = failure.diagnostics().get(0);
    assertEquals(id, finding.id(), finding::toString);
    assertEquals(line, finding.location().line(), finding::toString);
    Path expected = project.component("Braking_Decision");
    assertEquals(expected.toString(), finding.location().file());
  }

  @Test
  void outputWithoutEndEndsTheSimulation() throws Exception {
    AebProject project =
        new AebProject(folder).with("Braking_Decision", "failing/writes_without_end.py");
    assertEquals("simulation.limit", failure(project, NodeLimits.DEFAULT));
  }

  @InTurn
  @Test
  void suiteThatTakesTooLongIsEnded() throws Exception {
    AebProject project = new AebProject(folder).with("Braking_Decision", "failing/hangs.py");
    NodeLimits limits =
        new NodeLimits(Duration.ofHours(1), Duration.ofHours(1), Duration.ofSeconds(3));
    assertEquals("simulation.run.timeout", failure(project, limits));
  }

  private static String failure(AebProject project, NodeLimits limits) {
    SimulationRequest request =
        project
            .request(List.of(AebProject.scenario("stopped-vehicle-50")))
            .with(it -> it.withLimits(limits));
    DiagnosticException failure =
        assertThrows(DiagnosticException.class, () -> AebProject.simulate(request));
    return failure.diagnostics().get(0).id();
  }

  @InTurn
  @Test
  void resultDependsNeitherOnTheNumberOfProcessesNorOnTheOrder() throws Exception {
    AebProject project = new AebProject(folder);
    List<Scenario> scenarios = AebProject.scenarios();
    SimulationResult one =
        AebProject.simulate(project.request(scenarios).with(it -> it.withProcesses(1)));
    SimulationResult two = AebProject.simulate(project.request(scenarios));
    assertEquals(one.verdicts(), two.verdicts());
    assertEquals(one.measurements().runId(), two.measurements().runId());
    assertArrayEquals(withoutHost(one), withoutHost(two));

    List<Scenario> reversed = new ArrayList<>(scenarios);
    Collections.reverse(reversed);
    List<ScenarioVerdict> verdicts = new ArrayList<>(project.simulate(reversed).verdicts());
    Collections.reverse(verdicts);
    assertEquals(one.verdicts(), verdicts);
  }

  private static String[] withoutHost(SimulationResult result) {
    return new String(result.toJson(), java.nio.charset.StandardCharsets.UTF_8)
        .split("\"host\"", 2)[0].split("\n");
  }

  @Test
  void progressHearsOfEveryScenario() throws Exception {
    AebProject project = new AebProject(folder);
    List<String> heard = Collections.synchronizedList(new ArrayList<>());
    Simulation.run(
        project.request(AebProject.scenarios()), PythonEnvironment.ensure(line -> {}), heard::add);
    Collections.sort(heard);
    assertEquals(AebProject.scenarios().stream().map(Scenario::name).toList(), heard);
  }

  @Test
  void interruptEndsTheSimulationAndItsProcesses() throws Exception {
    AebProject project = new AebProject(folder).with("Braking_Decision", "failing/hangs.py");
    ThreadGroup all = new ThreadGroup("of the simulation");
    FutureTask<SimulationResult> simulation =
        new FutureTask<>(() -> project.simulate(AebProject.scenarios()));
    Thread caller = new Thread(all, simulation);
    caller.start();
    Thread.sleep(1500);
    caller.interrupt();
    ExecutionException e = assertThrows(ExecutionException.class, simulation::get);
    assertInstanceOf(InterruptedException.class, e.getCause());
    caller.join();
    Thread[] left = new Thread[all.activeCount()];
    int count = all.enumerate(left);
    assertTrue(
        Arrays.stream(left, 0, count).noneMatch(it -> it.getName().startsWith("simulation ")),
        () -> Arrays.toString(left));
  }

  @Test
  void phasesOfTheNodesFollowFromTheSeed() throws Exception {
    AebProject project = new AebProject(folder);
    Path file = folder.resolve("other.yaml");
    String text = Files.readString(AebProject.EXAMPLE.resolve("scenarios/empty-road.yaml"));
    Files.writeString(file, text.replace("seed: 10", "seed: 11"));
    List<Scenario> scenarios =
        List.of(AebProject.scenario("empty-road"), Scenario.read(file, AebProject.BENCH));
    List<ScenarioVerdict> verdicts = project.simulate(scenarios).verdicts();
    assertNotEquals(verdicts.get(0).latency(), verdicts.get(1).latency());
  }

  @ParameterizedTest
  @ValueSource(strings = {"float32 brakes", "bool brake"})
  void vehicleNeedsItsMessagesAsTheyAreDefinedByCarla(String field) throws Exception {
    Path messages = folder.resolve("msg/carla_msgs/msg");
    Files.createDirectories(messages);
    Path original = AebProject.EXAMPLE.resolve("software-base/msg/carla_msgs/msg");
    for (String file : List.of("CarlaEgoVehicleControl.msg", "CarlaEgoVehicleStatus.msg")) {
      String text = Files.readString(original.resolve(file));
      Files.writeString(messages.resolve(file), text.replace("float32 brake", field));
    }
    SimulationRequest request = new AebProject(folder).request(AebProject.scenarios());
    SimulationRequest changed =
        SimulationRequest.of(
            request.chain(),
            request.packageFolder(),
            request.manifest(),
            MessageCatalog.of(List.of(folder.resolve("msg"))),
            request.bench(),
            request.scenarios());
    DiagnosticException failure =
        assertThrows(DiagnosticException.class, () -> AebProject.simulate(changed));
    assertEquals(DiagnosticException.Reason.INPUT, failure.reason());
    assertEquals("message.field.missing", failure.diagnostics().get(0).id());
    assertTrue(
        failure
            .diagnostics()
            .get(0)
            .location()
            .file()
            .matches(".*carla_msgs/msg/CarlaEgoVehicle(Status|Control)[.]msg"));
  }

  @Test
  void errorInTheListenerIsNotSwallowed() throws Exception {
    SimulationRequest request = new AebProject(folder).request(AebProject.scenarios());
    assertThrows(
        IllegalStateException.class,
        () ->
            Simulation.run(
                request,
                PythonEnvironment.ensure(line -> {}),
                name -> {
                  throw new IllegalStateException();
                }));
  }
}
