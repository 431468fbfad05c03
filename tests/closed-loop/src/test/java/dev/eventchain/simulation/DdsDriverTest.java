package dev.eventchain.simulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.fixtures.InTurn;
import dev.eventchain.sandbox.PythonEnvironment;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.Measurements;
import dev.eventchain.simulation.verdict.MessageFlow;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.OptionalLong;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.ResourceLock;

/** Tests nodes as separate processes, connected by Cyclone DDS. */
@ResourceLock("processes of nodes")
class DdsDriverTest {

  private static final ObjectMapper JSON = new ObjectMapper();

  @TempDir Path folder;

  private static SimulationResult onDds(SimulationRequest request) throws InterruptedException {
    return Simulation.run(
        request.with(it -> it.withDriver(SimulationDriver.DDS)),
        PythonEnvironment.ensureWithCycloneDds(line -> {}),
        verdict -> {});
  }

  @InTurn
  @Test
  void whatIsMeasuredOnTheWireIsWhatLockstepMeasures() throws Exception {
    AebProject project = new AebProject(folder);
    List<Scenario> scenarios =
        List.of(AebProject.scenario("stopped-vehicle-50"), AebProject.scenario("slow-approach"));
    SimulationResult lockstep = project.simulate(scenarios);
    SimulationResult dds = onDds(project.request(scenarios));
    assertEquals(List.of(), dds.diagnostics());
    assertEquals(measured(lockstep), measured(dds));
  }

  /** Returns all measurements that do not depend on the machine. */
  private static String measured(SimulationResult result) throws IOException {
    ObjectNode json = (ObjectNode) JSON.readTree(result.toJson());
    return json.without("host").toPrettyString().replaceAll("\"host[^\\n]*", "");
  }

  @InTurn
  @Test
  void inRealTimeAScenarioIsJudgedOrTheOverrunIsSaid() throws Exception {
    AebProject project = new AebProject(folder);
    SimulationRequest request = project.request(List.of(AebProject.scenario("slow-approach")));
    SimulationResult result =
        Simulation.run(
            // Another scenario shows that the software does brake.
            request.with(
                it -> it.withDriver(SimulationDriver.DDS_IN_REAL_TIME).ofAllScenarios(false)),
            PythonEnvironment.ensureWithCycloneDds(line -> {}),
            verdict -> {});
    ScenarioVerdict verdict = result.verdicts().get(0);
    boolean overrun =
        verdict.criteria().stream().allMatch(each -> each.measured().contains("behind the clock"));
    assertTrue(
        overrun ? !verdict.tested() && !verdict.passed() : verdict.tested(),
        () -> verdict.worked() + " " + verdict.criteria());
    for (Measurements.Node node : result.measurements().nodes()) {
      assertTrue(node.activations() > 10, node.name());
      double longest = node.executionTime().orElseThrow().maximum();
      assertTrue(longest > 0 && longest != Math.rint(longest), node.name() + " " + longest);
    }
    MessageFlow flow = result.measurements().flow();
    for (MessageFlow.Hop hop : flow.hops()) {
      boolean isKnown = !hop.reader().equals(MessageFlow.VEHICLE);
      assertEquals(isKnown, hop.waiting().filter(it -> it.minimum() >= 0).isPresent(), hop::words);
    }
    assertTrue(flow.topics().stream().allMatch(each -> each.lost().isPresent()));
  }

  @InTurn
  @Test
  void messagesAreRecordedFromTheWire() throws Exception {
    AebProject project = new AebProject(folder);
    Path recordings = Files.createDirectory(folder.resolve("recordings"));
    onDds(
        project
            .request(List.of(AebProject.scenario("slow-approach")))
            .with(it -> it.withRecordings(recordings)));
    assertTrue(Files.size(recordings.resolve("slow-approach.mcap")) > 100_000);
  }

  @InTurn
  @Test
  void errorOfAComponentIsShownWithItsLine() throws Exception {
    AebProject project = new AebProject(folder);
    Path component = project.component("TTC_Calculation");
    String source = Files.readString(component);
    Files.writeString(
        component,
        source.replaceFirst("(def execute\\(.*\\n)", "$1        raise ValueError('broken')\n"));
    Diagnostic found = refusal(project.request(List.of(AebProject.scenario("slow-approach"))));
    assertEquals("component.raised", found.id());
    assertTrue(found.message().contains("broken"), found::message);
    assertTrue(found.location().line() > 0);
  }

  /** Node code that creates a file at its twentieth activation, and waits for a signal. */
  private static final String MARKED =
      """

      import pathlib
      import time
      _execute = TTC_Calculation_node.execute
      _calls = []
      def _marked(self):
          _calls.append(self)
          if len(_calls) == 20:
              pathlib.Path("approaches").touch()
              while True:
                  time.sleep(0.01)
          _execute(self)
      TTC_Calculation_node.execute = _marked
      """;

  @InTurn
  @Test
  void aNodeThatIsStoppedWhileTheVehicleApproachesIsNamed() throws Exception {
    Diagnostic found = whileItRuns("STOP");
    assertEquals("simulation.node.lost", found.id());
    assertTrue(
        found.message().matches("Node TTC_Calculation was stopped 0\\.\\d*[1-9]\\d* s into .*"),
        found::message);
  }

  @Test
  void aNodeThatIsKilledWhileTheVehicleApproachesIsNamed() throws Exception {
    Diagnostic found = whileItRuns("KILL");
    assertEquals("simulation.process.ended", found.id());
    assertTrue(found.message().startsWith("The process of node TTC_Calculation "), found::message);
  }

  /** Sends a signal to a node in the middle of a scenario; no process is left after that. */
  private Diagnostic whileItRuns(String signal) throws Exception {
    AebProject project = new AebProject(folder);
    Path node = folder.resolve("aeb/aeb/ttc_calculation_node.py");
    Files.writeString(node, MARKED, StandardOpenOption.APPEND);
    SimulationRequest request =
        project
            .request(List.of(AebProject.scenario("stopped-vehicle-50")))
            .with(it -> it.withProcesses(1));
    long before = hosts();
    CompletableFuture<Diagnostic> running =
        CompletableFuture.supplyAsync(
            () -> refusal(request), command -> new Thread(command).start());
    OptionalLong host = OptionalLong.empty();
    while (host.isEmpty() && !running.isDone()) {
      Thread.sleep(5);
      host = descendants().filter(DdsDriverTest::isMarked).mapToLong(ProcessHandle::pid).findAny();
    }
    new ProcessBuilder("kill", "-" + signal, Long.toString(host.orElseThrow())).start().waitFor();
    Diagnostic found = running.join();
    assertEquals(before, hosts());
    return found;
  }

  private static long hosts() {
    return descendants().count();
  }

  private static Stream<ProcessHandle> descendants() {
    return ProcessHandle.current()
        .descendants()
        .filter(it -> it.info().commandLine().orElse("").contains("eventchain_ros2.node_host"));
  }

  /**
   * Returns whether a process hosts the node: it has the threads of DDS, unlike its parent and its
   * component.
   */
  private static boolean isMarked(ProcessHandle handle) {
    Path process = Path.of("/proc", Long.toString(handle.pid()));
    try (Stream<Path> threads = Files.list(process.resolve("task"))) {
      return threads.count() > 3 && Files.exists(process.resolve("cwd/approaches"));
    } catch (IOException | UncheckedIOException e) {
      return false; // it has ended
    }
  }

  private static Diagnostic refusal(SimulationRequest request) {
    DiagnosticException refused = assertThrows(DiagnosticException.class, () -> onDds(request));
    return refused.diagnostics().get(0);
  }
}
