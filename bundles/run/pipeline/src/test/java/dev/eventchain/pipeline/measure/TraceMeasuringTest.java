package dev.eventchain.pipeline.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.DiagnosticException.Reason;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.fixtures.Projects;
import dev.eventchain.fixtures.Repository;
import dev.eventchain.output.OutputFolder.OnEdit;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.simulation.tracing.RecordedTrace;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the findings about a trace of a project's nodes, each with a trace or a model changed. */
class TraceMeasuringTest {

  private static final Path TRACE =
      Repository.ROOT.resolve("bundles/robot/simulation/src/test/resources/tracing/radar-aeb.txt");

  @TempDir Path folder;
  private Path project;
  private Path trace;

  @BeforeEach
  void copy() throws IOException {
    project = Projects.copy(Repository.ROOT.resolve("examples/radar-aeb"), folder.resolve("p"));
    trace = Files.copy(TRACE, folder.resolve("drive.txt"));
  }

  private static void change(Path file, String pattern, String replacement) throws IOException {
    String text = Files.readString(file);
    String changed = text.replaceAll(pattern, replacement);
    assertFalse(text.equals(changed), pattern);
    Files.writeString(file, changed);
  }

  private TraceMeasuring measure() {
    Project opened = Project.open(project);
    return TraceMeasuring.of(
        opened,
        opened.model(project.resolve("out")).orElseThrow(),
        project.resolve("out"),
        trace,
        Duration.ofSeconds(30),
        Suppressions.NONE,
        OnEdit.KEEP);
  }

  /** Returns the findings as {@code severity id message}. */
  private List<String> found() {
    return measure().files().diagnostics().stream()
        .map(
            it ->
                it.severity().toString().toLowerCase(Locale.ROOT)
                    + " "
                    + it.id()
                    + " "
                    + it.message())
        .toList();
  }

  private boolean passed() throws IOException {
    return Files.readString(project.resolve("out/traced/chain.measured.xmi"))
        .contains("scenario=\"drive.txt\" passed=\"true\"");
  }

  @Test
  void aTraceWithinTheModelHasNoFinding() throws IOException {
    TraceMeasuring measured = measure();
    assertEquals(List.of(), measured.files().diagnostics());
    assertTrue(passed());
    assertTrue(measured.text().contains("radar_to_brake  6 "), measured.text());
    assertTrue(
        Files.readString(project.resolve("out/traced/measurements.json"))
            .contains("\"constraint\" : \"radar_to_brake\""));
    assertTrue(Files.notExists(project.resolve("out/traced/measured-times.diff")));
  }

  @Test
  void theSameTraceGivesTheSameBytes() throws IOException {
    measure();
    String first = Files.readString(project.resolve("out/traced/measurements.json"));
    measure();
    assertEquals(first, Files.readString(project.resolve("out/traced/measurements.json")));
  }

  @Test
  void aMaximumThatIsExceededIsAnError() throws IOException {
    change(project.resolve("model/chain.xmi"), "maximum=\"100.0\"", "maximum=\"12.0\"");
    List<String> found = found();
    assertEquals(1, found.size(), found.toString());
    assertTrue(
        found
            .get(0)
            .startsWith(
                "error trace.latency.exceeded 'radar_to_brake' allows 12 ms, but took up to 12."),
        found.toString());
    assertFalse(passed());
  }

  @Test
  void numbersOfTheModelThatDoNotHoldAreWarnings() throws IOException {
    change(project.resolve("model/chain.xmi"), "Time=\"2.0\"", "Time=\"1.0\"");
    change(project.resolve("model/chain.xmi"), "frequency=\"50.0\"", "frequency=\"500.0\"");
    change(
        project.resolve("software-base/components.json"),
        "\"worst_case_execution_time\": [0-9.]+",
        "\"worst_case_execution_time\": 1.0");
    List<String> ids = found().stream().map(it -> it.replaceAll("(\\S+ \\S+) .*", "$1")).toList();
    assertEquals(
        List.of(
            "warning trace.time.above",
            "warning trace.period.above",
            "warning trace.time.above",
            "warning trace.period.above",
            "warning trace.period.above",
            "warning trace.latency.above-bound"),
        ids);
    String diff = Files.readString(project.resolve("out/traced/measured-times.diff"));
    assertTrue(diff.contains("+    \"worst_case_execution_time\": 1."), diff);
  }

  /** Its last execution publishes nothing any more, as if it hung before. */
  @Test
  void messagesThatAreNotAnsweredForTooLongAreAnError() throws IOException {
    change(project.resolve("model/chain.xmi"), "maximum=\"100.0\"", "maximum=\"13.0\"");
    change(trace, "(?s)(.*ros2:)rcl_publish(`.*ros2:rcl_publish`)", "$1other$2");
    List<String> found = found();
    assertTrue(
        found.stream()
            .anyMatch(
                it ->
                    it.startsWith(
                        "error trace.latency.unanswered 'radar_to_brake' allows 13 ms, but to the end of the trace, ")),
        found.toString());
    assertFalse(passed());
    String json = Files.readString(project.resolve("out/traced/measurements.json"));
    assertTrue(
        json.replaceAll("\\s", "").contains("\"unanswered\":{\"count\":1,\"untilEnd\":15.2"), json);
  }

  @Test
  void callbacksOfAThreadThatOverlapAreThoseOfTwoProcesses() throws IOException {
    change(trace, "(?s)(.*\\n\\n)(.*?callback_start.*?callback: )([^\\n]*)", "$1$2$3\n\n$2 0x1");
    List<String> found = found();
    assertTrue(
        found.contains(
            "error trace.thread.mixed Callbacks of one thread overlap (vpid 27156, vtid 27161), so that several processes have the same ids and their times are mixed."),
        found.toString());
    assertFalse(passed());
  }

  @Test
  void lostEventsLeaveNothingProved() throws IOException {
    change(trace, "\\z", "\nDiscarded events (132 events)\n");
    assertEquals(
        List.of(
            "error trace.lost Events of the trace were lost (132 events), so that each time is a lower bound and no constraint is shown to hold."),
        found());
    assertFalse(passed());
  }

  @Test
  void aTraceOfOtherNodesIsNoPass() throws IOException {
    measure();
    change(trace, "node_name: ", "node_name: other_");
    List<String> found = found();
    assertEquals(1, found.size());
    assertEquals(
        "error trace.unmatched The trace has no component of the chain: its nodes are /other_brake_request, /other_collision_warning, /other_radar_driver, /other_radar_tracking.",
        found.get(0));
    assertTrue(Files.notExists(project.resolve("out/traced/measurements.json")));
    Files.writeString(trace, "Stream beginning:\n\nStream end\n");
    assertTrue(found().get(0).contains("it has no node at all"));
  }

  @Test
  void aComponentThatIsNotThereLeavesTheConstraintUnmeasured() throws IOException {
    change(trace, "node_name: brake_request", "node_name: other");
    String hint = measure().files().diagnostics().get(0).hint();
    assertTrue(hint.contains("The trace also has /other, /radar_driver: if"), hint);
    List<String> found = found();
    assertEquals(2, found.size(), found.toString());
    assertEquals(
        "warning trace.node.missing 'Brake_Request' is not in the trace: no node is called 'brake_request'.",
        found.get(0));
    assertTrue(found.get(1).startsWith("error trace.latency.unmeasured"), found.toString());
    assertFalse(passed());
  }

  @Test
  void aComponentThatDoesNothingIsSaid() throws IOException {
    change(trace, "topic_name: (/aeb/threat|/cluster)", "topic_name: /other$1");
    change(trace, "callback_start", "callback_began");
    List<String> found = found();
    assertTrue(
        found.contains(
            "warning trace.node.missing 'Collision_Warning' did nothing in the trace: no callback was executed, and nothing published."),
        found.toString());
  }

  /** A model without constraints has none that could be unmeasured. */
  @Test
  void componentsThatAllDoNothingAreNoPass() throws IOException {
    change(project.resolve("model/chain.xmi"), "(?s)<latencyConstraints.*?/>", "");
    change(trace, "topic_name: ", "topic_name: /other");
    change(trace, "callback_start", "callback_began");
    assertTrue(
        found()
            .contains(
                "error trace.unmatched No component of the chain did anything in the trace, so that nothing was measured."));
    assertFalse(passed());
  }

  /** The driver of the radar has a thread of its own, whose events are left out. */
  @Test
  void publishersThatAreNotTracedAreSaid() throws IOException {
    String text = Files.readString(trace);
    Matcher thread = Pattern.compile("(vtid: .*\\R)(?:.*\\R){4}.*radar_driver").matcher(text);
    assertTrue(thread.find());
    Files.writeString(
        trace,
        Stream.of(text.split("\\R\\R"))
            .filter(it -> !it.contains(thread.group(1)))
            .collect(Collectors.joining("\n\n")));
    assertEquals(
        List.of(
            "error trace.publisher.missing The publisher of /radar/target is not in the trace: its 6 messages count as published at the time that they carry, by the clock of another process or machine."),
        found());
  }

  @Test
  void messagesFromBeforeTheTraceAreSaid() throws IOException {
    change(trace, "(?s)^(.*?source_timestamp: )[\\d,]+", "$11");
    List<String> found = found();
    assertTrue(
        found.contains(
            "info trace.message.earlier Messages of /radar/target that 'Radar_Tracking' read were published before the trace began, and are left out: 1."),
        found.toString());
  }

  @Test
  void messagesThatNoPublicationHasAreSaid() throws IOException {
    change(trace, "Event `ros2:rmw_publish`", "Event `ros2:other`");
    change(trace, "Event `ros2:rcl_publish`", "Event `ros2:other`");
    List<String> found = found();
    assertTrue(
        found.contains(
            "error trace.message.unmatched 6 times, it is not known which message of /radar/target 'Radar_Tracking' read."),
        found.toString());
    assertFalse(passed());
  }

  private RecordedTrace read(String... program) {
    return Babeltrace.read(folder, List.of(program));
  }

  private Diagnostic failure(Reason reason, String... program) {
    DiagnosticException failure = assertThrows(DiagnosticException.class, () -> read(program));
    assertEquals(reason, failure.reason());
    return failure.diagnostics().get(0);
  }

  @Test
  void aFolderIsReadByBabeltrace() {
    RecordedTrace read =
        read("sh", "-c", "test \"$0\" = --component=sink.text.details && cat \"$1\"/drive.txt");
    assertEquals(4, read.nodes().size());
  }

  @Test
  void whereThereIsNoBabeltraceItIsAskedFor() {
    Diagnostic missing = failure(Reason.UNAVAILABLE, folder.resolve("nothing").toString());
    assertEquals("trace.reader", missing.id());
    assertTrue(missing.hint().contains("apt-get install babeltrace2"), missing.hint());
  }

  /** What it had read by then is no whole trace. */
  @Test
  void aFailureOfBabeltraceIsAFailure() {
    Diagnostic failed =
        failure(Reason.INPUT, "sh", "-c", "cat \"$1\"/drive.txt; echo no CTF >&2; exit 7");
    assertEquals("trace.unreadable", failed.id());
    assertTrue(failed.message().contains("exit code 7: no CTF"), failed.message());
    Diagnostic other = failure(Reason.INPUT, "sh", "-c", "echo no folder of CTF >&2; exit 1");
    assertTrue(other.message().contains("exit code 1: no folder of CTF"), other.message());
  }
}
