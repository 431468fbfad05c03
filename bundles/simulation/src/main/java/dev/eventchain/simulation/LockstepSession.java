package dev.eventchain.simulation;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Printable;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.python.ConfinedProcess;
import dev.eventchain.simulation.LockstepChannel.Frame;
import dev.eventchain.simulation.LockstepChannel.Inbound;
import java.io.EOFException;
import java.io.IOException;
import java.nio.BufferUnderflowException;
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

  /**
   * What there is to say of a process that has ended.
   *
   * @param standardError what it complained about
   */
  record LastWords(ConfinedProcess.Cause cause, String standardError) {}

  private static final ObjectMapper JSON = new ObjectMapper();
  private static final int LAST_LINES = 12;
  private static final ByteBuffer NOTHING = ByteBuffer.allocate(0);

  private final LockstepChannel channel;
  private final Watchdog watchdog;
  private final Supplier<LastWords> lastWords;
  private final UserFiles files;
  private JsonNode configuration;
  private long now;
  private List<Outbound> commands = new ArrayList<>();

  /**
   * Over an open channel.
   *
   * @param watchdog ends the other side when an answer takes too long
   * @param lastWords ends the other side and says how it ended
   * @param files turns the other side's file names into those that people know
   */
  LockstepSession(
      LockstepChannel channel, Watchdog watchdog, Supplier<LastWords> lastWords, UserFiles files) {
    this.channel = channel;
    this.watchdog = watchdog;
    this.lastWords = lastWords;
    this.files = files;
  }

  /** Starts with fresh nodes at time 0. Answers what the process says of itself. */
  JsonNode configure(JsonNode newConfiguration) {
    int kind = configuration == null ? LockstepChannel.CONFIGURE : LockstepChannel.RESET;
    configuration = newConfiguration;
    now = 0;
    commands = new ArrayList<>();
    byte[] payload = configuration.toString().getBytes(StandardCharsets.UTF_8);
    return json(ask(LockstepChannel.READY, () -> channel.send(kind, payload)));
  }

  /**
   * Publishes messages now and lets time pass; answers what the nodes published meanwhile, in the
   * order of time.
   */
  List<Outbound> step(long until, List<Inbound> messages) {
    Frame frame = ask(LockstepChannel.STEPPED, () -> channel.sendStep(until, messages));
    List<Outbound> published = published(frame.payload());
    long earliest = now;
    for (Outbound command : published) {
      boolean known = command.topic() < configuration.path("world_subscribes").size();
      if (!known || command.time() < earliest || command.time() >= until) {
        throw garbage("a message that cannot be one of this step");
      }
      earliest = command.time();
    }
    now = until;
    // What they say would fill the memory: whole sensor data, if they are recorded.
    published.forEach(each -> commands.add(new Outbound(each.time(), each.topic(), NOTHING)));
    return published;
  }

  private List<Outbound> published(ByteBuffer payload) {
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
      if (!payload.hasRemaining()) {
        return published;
      }
    } catch (BufferUnderflowException | IllegalArgumentException | IndexOutOfBoundsException e) {
      // Said below.
    }
    throw garbage("an answer to a step that is not as long as it says");
  }

  /** Ends the scenario; answers what the nodes did. */
  RunLog finish() {
    Frame frame =
        ask(LockstepChannel.FINISHED, () -> channel.send(LockstepChannel.FINISH, new byte[0]));
    try {
      RunLog log = RunLog.parse(json(frame));
      new RunLogCheck(log, configuration, now).check(commands);
      return log;
    } catch (IllegalArgumentException e) {
      throw garbage("a record of activations that cannot be one: " + e.getMessage());
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
    String message = Printable.line(failure.path("message").asText(""));
    SourceLocation location =
        new SourceLocation(
            files.name(failure.path("file").asText("")),
            failure.path("line").asInt(0),
            failure.path("column").asInt(0),
            node,
            failure.path("excerpt").asText(""));
    String text = node.isEmpty() ? message : "Node " + node + ": " + message;
    return failure(
        Diagnostic.error(failure.path("id").asText("node.failed"), text, location)
            .withHint(failure.path("hint").asText("")));
  }

  private DiagnosticException ended() {
    LastWords last = lastWords.get();
    if (!watchdog.reason().isEmpty()) {
      String message = "The nodes did not answer within " + watchdog.reason() + " and were ended.";
      return failure(
          Diagnostic.error("simulation.step.timeout", message, files.folder())
              .withHint("Look for an endless loop or a wait in a node."));
    }
    return switch (last.cause()) {
      case OUTPUT ->
          ended("simulation.limit", "The nodes write to standard error without end.", last);
      case WALL_TIME, CPU_TIME ->
          ended("simulation.run.timeout", "The simulation took longer than it may.", last);
      default ->
          ended(
              "simulation.process.ended",
              "The process that runs the nodes ended before the scenario did.",
              last);
    };
  }

  private DiagnosticException ended(String id, String message, LastWords last) {
    return failure(Diagnostic.error(id, message, files.folder()).withHint(text(last)));
  }

  private DiagnosticException garbage(String what) {
    String message = "The process that runs the nodes sent " + what + ".";
    return failure(
        Diagnostic.error("simulation.protocol", message, files.folder())
            .withHint(text(lastWords.get())));
  }

  private static String text(LastWords words) {
    List<String> lines = words.standardError().lines().toList();
    List<String> last = lines.subList(Math.max(0, lines.size() - LAST_LINES), lines.size());
    return last.isEmpty()
        ? "It said nothing about why."
        : "It wrote at last:\n" + String.join("\n", last);
  }

  private static DiagnosticException failure(Diagnostic diagnostic) {
    return new DiagnosticException(DiagnosticException.Reason.FINDINGS, diagnostic);
  }
}
