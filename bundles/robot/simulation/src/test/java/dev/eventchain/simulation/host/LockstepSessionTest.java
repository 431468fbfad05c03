package dev.eventchain.simulation.host;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.sandbox.ConfinedProcess;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.PipedInputStream;
import java.io.PipedOutputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.HexFormat;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the Java side of the protocol against hand-written answers. */
class LockstepSessionTest {

  private static LockstepSession session(InputStream input, OutputStream output) {
    return session(input, output, watchdog(Duration.ofMinutes(1), () -> {}));
  }

  private static LockstepSession session(
      InputStream input, OutputStream output, Watchdog watchdog) {
    return new LockstepSession(new HostChannel(input, output), watchdog, failures(139));
  }

  private static HostFailures failures(int code) {
    return new HostFailures(
        "The process that runs the nodes",
        () ->
            new HostFailures.LastWords(
                new ConfinedProcess.Termination(ConfinedProcess.Cause.EXITED, code),
                "Traceback\nValueError: last words\n"),
        new UserFiles(Path.of("out/ros2/aeb")));
  }

  private static Watchdog watchdog(Duration wallTime, Runnable end) {
    return new Watchdog(Duration.ofMinutes(1), wallTime, () -> Duration.ZERO, end);
  }

  private static byte[] frame(int kind, String text) {
    byte[] payload = text.getBytes(StandardCharsets.UTF_8);
    ByteBuffer frame = ByteBuffer.allocate(5 + payload.length).order(ByteOrder.LITTLE_ENDIAN);
    byte[] bytes = new byte[5 + payload.length];
    frame.putInt(1 + payload.length).put((byte) kind).put(payload).flip().get(bytes);
    return bytes;
  }

  private static Diagnostic failure(byte[] answer) {
    LockstepSession session =
        session(new ByteArrayInputStream(answer), OutputStream.nullOutputStream());
    DiagnosticException exception =
        assertThrows(
            DiagnosticException.class,
            () -> session.configure(JsonNodeFactory.instance.objectNode()));
    assertEquals(DiagnosticException.Reason.FINDINGS, exception.reason());
    return exception.diagnostics().get(0);
  }

  /** Returns a configured session with a world that receives three topics. */
  private static LockstepSession configured(String answer, ByteArrayOutputStream written) {
    ByteArrayOutputStream answers = new ByteArrayOutputStream();
    answers.writeBytes(frame(HostChannel.READY, "{}"));
    answers.writeBytes(HexFormat.of().parseHex(answer));
    LockstepSession session = session(new ByteArrayInputStream(answers.toByteArray()), written);
    ObjectNode configuration = JsonNodeFactory.instance.objectNode();
    configuration.putArray("world_subscribes").add("/a").add("/b").add("/c");
    session.configure(configuration);
    written.reset();
    return session;
  }

  @Test
  void stepIsWrittenAsTheProtocolSays() {
    ByteArrayOutputStream written = new ByteArrayOutputStream();
    String answer =
        "16000000" + "04" + "0100" + "40420f0000000000" + "0200" + "05000000" + "0001000007";
    List<NodeSession.Outbound> published =
        configured(answer, written)
            .step(
                50_000_000L,
                List.of(new NodeSession.Inbound(3, ByteBuffer.wrap(new byte[] {0, 1, 0, 0, 9}))));
    assertEquals(
        "16000000" + "03" + "80f0fa0200000000" + "0100" + "0300" + "05000000" + "0001000009",
        HexFormat.of().formatHex(written.toByteArray()));
    assertEquals(1, published.size());
    assertEquals(1_000_000L, published.get(0).time());
    assertEquals(2, published.get(0).topic());
    assertEquals(ByteBuffer.wrap(new byte[] {0, 1, 0, 0, 7}), published.get(0).message());
  }

  /** Time, topic and length of the message that is published in a step from 0 to 1 ms. */
  @ParameterizedTest
  @CsvSource({
    "ffffffffffffffff, 0000, 00000000, a message that cannot belong to this step",
    "40420f0000000000, 0000, 00000000, a message that cannot belong to this step",
    "0000000000000000, 0300, 00000000, a message that cannot belong to this step",
    "0000000000000000, 0000, 01000000, an answer to a step that is not as long as it says",
    "0000000000000000, 0000, ffffffff, an answer to a step that is not as long as it says",
    "0000000000000000, 0000, 0000000000, an answer to a step that is not as long as it says"
  })
  void messageThatCannotBeIsNotBelieved(String time, String topic, String length, String what) {
    String rest = "04" + "0100" + time + topic + length;
    String answer = String.format(Locale.ROOT, "%02x000000", rest.length() / 2) + rest;
    LockstepSession session = configured(answer, new ByteArrayOutputStream());
    DiagnosticException exception =
        assertThrows(DiagnosticException.class, () -> session.step(1_000_000L, List.of()));
    Diagnostic finding = exception.diagnostics().get(0);
    assertEquals("simulation.protocol", finding.id());
    assertTrue(finding.message().contains(what), finding::message);
  }

  @Test
  void secondScenarioIsAReset() {
    ByteArrayOutputStream written = new ByteArrayOutputStream();
    byte[] ready = frame(HostChannel.READY, "{}");
    byte[] twice = new byte[2 * ready.length];
    System.arraycopy(ready, 0, twice, 0, ready.length);
    System.arraycopy(ready, 0, twice, ready.length, ready.length);
    LockstepSession session = session(new ByteArrayInputStream(twice), written);
    session.configure(JsonNodeFactory.instance.objectNode());
    session.configure(JsonNodeFactory.instance.objectNode());
    assertEquals(HostChannel.CONFIGURE, written.toByteArray()[4]);
    assertEquals(HostChannel.RESET, written.toByteArray()[written.size() - 3]);
  }

  @ParameterizedTest
  @CsvSource({
    "48656c6c6f2c20776f726c64, a frame of kind 111 with length 1819043144",
    "ffffffff02, a frame of kind 2 with length -1",
    "0000000002, a frame of kind 2 with length 0",
    "0300000004ffff, a frame of kind 4 instead of 2",
    "04000000027b7b7b, broken JSON"
  })
  void garbageIsReportedWithTheProcessesLastWords(String hex, String what) {
    Diagnostic finding = failure(HexFormat.of().parseHex(hex));
    assertEquals("simulation.protocol", finding.id());
    assertTrue(finding.message().contains(what), finding::message);
    assertTrue(finding.hint().contains("last words"), finding::hint);
  }

  @ParameterizedTest
  @CsvSource({"''", "16000000", "1600000002"})
  void endWithinOrBeforeAnAnswerIsReportedWithLastWords(String hex) {
    Diagnostic finding = failure(HexFormat.of().parseHex(hex));
    assertEquals("simulation.process.ended", finding.id());
    assertEquals(
        "The process that runs the nodes ended before the scenario did, by signal 11.",
        finding.message());
    assertEquals("out/ros2/aeb", finding.location().file());
    assertTrue(finding.hint().contains("last words"), finding::hint);
  }

  /** Linux has 64 signals; {@code sys.exit(-1)} ends with the code 255. */
  @ParameterizedTest
  @CsvSource({
    "0, with the exit code 0",
    "128, with the exit code 128",
    "129, by signal 1",
    "192, by signal 64",
    "193, with the exit code 193",
    "255, with the exit code 255"
  })
  void exitCodesAreThoseOfSignalsAsFarAsThereAreSignals(int code, String how) {
    assertEquals(
        "The process that runs the nodes ended before the scenario did, " + how + ".",
        failures(code).ended("").diagnostics().get(0).message());
  }

  @Test
  void failureIsReportedAtItsPlaceUnderTheNameThatTheUserGave() {
    String file = Path.of("out/ros2/aeb/aeb/components/X.py").toAbsolutePath().toString();
    Diagnostic finding =
        failure(
            frame(
                HostChannel.FAILED,
                "{\"id\":\"component.raised\",\"message\":\"ValueError: no\",\"node\":\"X\","
                    + "\"file\":\""
                    + file
                    + "\",\"line\":7,\"column\":9,"
                    + "\"excerpt\":\"        raise ValueError\"}"));
    assertEquals("component.raised", finding.id());
    assertEquals("Node X: ValueError: no", finding.message());
    assertEquals("out/ros2/aeb/aeb/components/X.py:7:9", finding.location().toString());
    assertEquals("        raise ValueError", finding.location().excerpt());
  }

  @Test
  void silenceIsEndedByTheWatchdog() throws IOException {
    PipedOutputStream otherSide = new PipedOutputStream();
    try (PipedInputStream input = new PipedInputStream(otherSide);
        Watchdog watchdog = watchdog(Duration.ofMillis(50), () -> close(otherSide))) {
      LockstepSession session = session(input, OutputStream.nullOutputStream(), watchdog);
      DiagnosticException exception =
          assertThrows(DiagnosticException.class, () -> session.step(1, List.of()));
      assertEquals("simulation.step.timeout", exception.diagnostics().get(0).id());
    }
  }

  private static void close(OutputStream stream) {
    try {
      stream.close();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
