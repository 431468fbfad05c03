package dev.eventchain.simulation.tracing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.DiagnosticException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Tests what is read as a trace, and what is not ({@code trace.unreadable}). */
class RecordedTraceTest {

  static final Path TRACE = Path.of("src/test/resources/tracing/radar-aeb.txt");

  private static void refused(String text, String reason) {
    DiagnosticException failure =
        assertThrows(DiagnosticException.class, () -> TraceText.read(text));
    assertEquals("trace.unreadable", failure.diagnostics().get(0).id());
    String message = failure.diagnostics().get(0).message();
    assertTrue(message.contains(reason), message);
  }

  @Test
  void aTraceOfLttngHasItsNodes() throws IOException {
    RecordedTrace trace = TraceText.read(Files.readString(TRACE));
    assertEquals(
        List.of("/brake_request", "/collision_warning", "/radar_driver", "/radar_tracking"),
        trace.nodes());
    assertEquals(List.of(), trace.lost());
    assertEquals(24, trace.activity().publications.size());
    assertEquals(18, trace.activity().takes.size());
  }

  @Test
  void lostEventsAreCounted() {
    TraceText trace = new TraceText();
    trace.message(
        "[24,978,337 cycles, 1,795,958,410,326,814,993 ns from origin]\n[24,978,338 cycles, 1,795,958,410,327,986,297 ns from origin]\n{Trace 0, Stream class ID 0, Stream ID 1}\nDiscarded events (1,132 events)");
    trace.message("{Trace 0, Stream class ID 0, Stream ID 1}\nDiscarded events (200 events)");
    trace.message("Discarded packets (1 packet)");
    assertEquals(List.of("1 packets", "1332 events"), trace.read().lost());
  }

  @Test
  void aNumberOfLostEventsMayBeUnknown() {
    assertEquals(
        List.of("an unknown number of events"),
        new TraceText().message("Discarded events").read().lost());
    assertEquals(
        List.of("a stream does not count them"),
        new TraceText()
            .message("Trace class:\n  Stream class (ID 0):\n    Supports discarded events: No")
            .read()
            .lost());
  }

  /** A part of a trace has fewer and shorter times than the whole. */
  @Test
  void aTraceThatIsCutOffIsRefused() throws IOException {
    String text = Files.readString(TRACE);
    refused(text.substring(0, text.length() / 2), "it is cut off, since 0 of 2 streams end");
    refused(text.substring(0, text.lastIndexOf("Stream end")), "1 of 2 streams end");
  }

  @Test
  void otherTextsAreRefused() {
    refused("", "it has no streams");
    refused(
        "[1795958382.741480495] (+?) vm ros2:rcl_node_init: { cpu_id = 0 }, { node_name = \"a\" }\n",
        "it has no streams");
  }

  @Test
  void eventsWithoutThreadOrTimeAreRefused() throws IOException {
    String text = Files.readString(TRACE);
    refused(text.replaceAll("    vtid: .*\n", ""), "the contexts vpid and vtid");
    refused(text.replaceAll(", [0-9,]+ ns from origin", ""), "has no time in ns");
  }

  @Test
  void numbersThatAreNoneAreRefused() {
    String large = "9,999,999,999,999,999,999";
    refused("Stream beginning:\n[1 cycles, " + large + " ns from origin]\n", large);
    refused("[1 cycles, - ns from origin]\n", "'-' is no number");
    refused("Discarded events (" + large + " events)\n", large);
  }

  @Test
  void eventsOfOtherInstrumentationAreSkipped() throws IOException {
    String text = Files.readString(TRACE).replace("Event `ros2:", "Event `other:");
    RecordedTrace trace = TraceText.read(text.replaceAll("    vtid: .*\n", ""));
    assertTrue(trace.events() > 100);
    assertEquals(List.of(), trace.nodes());
  }
}
