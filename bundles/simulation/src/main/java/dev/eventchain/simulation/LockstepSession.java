package dev.eventchain.simulation;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.simulation.LockstepChannel.Frame;
import dev.eventchain.simulation.LockstepChannel.Inbound;
import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;

/**
 * One process that runs the nodes in lock-step with a world: question and answer. Whatever goes
 * wrong in it becomes a finding that points to the place in the user's code, as far as that is
 * known.
 */
final class LockstepSession {

  /** A message that the nodes published, when, in ns, and on which topic of the configuration. */
  record Outbound(long time, int topic, ByteBuffer message) {}

  private static final ObjectMapper JSON = new ObjectMapper();
  private static final int LAST_LINES = 12;

  private final LockstepChannel channel;
  private final Watchdog watchdog;
  private final Supplier<String> standardError;
  private final UserFiles files;
  private boolean configured;

  /**
   * Over an open channel.
   *
   * @param watchdog ends the other side when an answer takes too long
   * @param standardError what the other side complained about until now
   * @param files turns the other side's file names into those that people know
   */
  LockstepSession(
      LockstepChannel channel, Watchdog watchdog, Supplier<String> standardError, UserFiles files) {
    this.channel = channel;
    this.watchdog = watchdog;
    this.standardError = standardError;
    this.files = files;
  }

  /** Starts with fresh nodes at time 0. Answers what the process says of itself. */
  JsonNode configure(JsonNode configuration) {
    int kind = configured ? LockstepChannel.RESET : LockstepChannel.CONFIGURE;
    configured = true;
    byte[] payload = configuration.toString().getBytes(StandardCharsets.UTF_8);
    return json(ask(LockstepChannel.READY, () -> channel.send(kind, payload)));
  }

  /** Publishes messages now and lets time pass; answers what the nodes published. */
  List<Outbound> step(long until, List<Inbound> messages) {
    Frame frame = ask(LockstepChannel.STEPPED, () -> channel.sendStep(until, messages));
    ByteBuffer payload = frame.payload();
    try {
      int count = Short.toUnsignedInt(payload.getShort());
      List<Outbound> published = new ArrayList<>(count);
      for (int i = 0; i < count; i++) {
        long time = payload.getLong();
        int topic = Short.toUnsignedInt(payload.getShort());
        int length = payload.getInt();
        ByteBuffer message = payload.slice(payload.position(), length);
        payload.position(payload.position() + length);
        published.add(new Outbound(time, topic, message));
      }
      return published;
    } catch (RuntimeException e) {
      throw garbage("an answer to a step that is not as long as it says");
    }
  }

  /** Ends the scenario; answers what the nodes did. */
  RunLog finish() {
    Frame frame =
        ask(LockstepChannel.FINISHED, () -> channel.send(LockstepChannel.FINISH, new byte[0]));
    try {
      return RunLog.parse(json(frame));
    } catch (IllegalArgumentException | NullPointerException e) {
      throw garbage("a record of activations that is incomplete: " + e.getMessage());
    }
  }

  private interface Question {
    void send() throws IOException;
  }

  private Frame ask(int expected, Question question) {
    watchdog.start();
    try {
      question.send();
      Frame frame = channel.receive();
      if (frame.kind() == LockstepChannel.FAILED) {
        throw failed(json(frame));
      }
      if (frame.kind() != expected) {
        throw garbage("a frame of kind " + frame.kind() + " instead of " + expected);
      }
      return frame;
    } catch (LockstepChannel.GarbageException e) {
      throw garbage(e.getMessage());
    } catch (EOFException e) {
      throw ended();
    } catch (IOException e) {
      throw ended(); // a broken pipe: the other side has gone while we wrote
    } finally {
      watchdog.stop();
    }
  }

  private JsonNode json(Frame frame) {
    try {
      return JSON.readTree(new String(frame.bytes(), StandardCharsets.UTF_8));
    } catch (JsonProcessingException e) {
      throw garbage("broken JSON: " + e.getOriginalMessage());
    }
  }

  /** The process said what went wrong in the user's code. */
  private DiagnosticException failed(JsonNode failure) {
    String node = failure.path("node").asText("");
    String message = failure.path("message").asText("");
    SourceLocation location =
        new SourceLocation(
            files.name(failure.path("file").asText("")),
            failure.path("line").asInt(0),
            failure.path("column").asInt(0),
            node,
            failure.path("excerpt").asText(""));
    String text = node.isEmpty() ? message : "Node " + node + ": " + message;
    return failure(Diagnostic.error(failure.path("id").asText("node.failed"), text, location));
  }

  private DiagnosticException ended() {
    if (watchdog.hasFired()) {
      String message =
          "The nodes did not answer within " + watchdog.limit().toMillis() + " ms and were ended.";
      return failure(
          Diagnostic.error("simulation.step.timeout", message, files.folder())
              .withHint("Look for an endless loop or a wait in a component's execute()."));
    }
    String message = "The process that runs the nodes ended before the scenario did.";
    return failure(
        Diagnostic.error("simulation.process.ended", message, files.folder())
            .withHint(lastWords()));
  }

  private DiagnosticException garbage(String what) {
    String message = "The process that runs the nodes sent " + what + ".";
    return failure(
        Diagnostic.error("simulation.protocol", message, files.folder()).withHint(lastWords()));
  }

  private String lastWords() {
    List<String> lines = standardError.get().lines().toList();
    List<String> last = lines.subList(Math.max(0, lines.size() - LAST_LINES), lines.size());
    return last.isEmpty()
        ? "It said nothing about why."
        : "It wrote at last:\n" + String.join("\n", last);
  }

  private static DiagnosticException failure(Diagnostic diagnostic) {
    return new DiagnosticException(DiagnosticException.Reason.FINDINGS, diagnostic);
  }
}
