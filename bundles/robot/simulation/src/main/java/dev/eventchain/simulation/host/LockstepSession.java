package dev.eventchain.simulation.host;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.simulation.host.HostChannel.Frame;
import dev.eventchain.simulation.host.NodeSession.Inbound;
import java.io.EOFException;
import java.io.IOException;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/**
 * A process that runs the nodes in lock-step with a world, by request and response. Failures become
 * findings that point to the location in the user's code, if known.
 */
final class LockstepSession implements NodeSession {

  private static final ObjectMapper JSON = new ObjectMapper();
  private static final ByteBuffer NOTHING = ByteBuffer.allocate(0);

  private final HostChannel channel;
  private final Watchdog watchdog;
  private final HostFailures failures;
  private JsonNode configuration;
  private long now;
  private List<Outbound> commands = new ArrayList<>();

  /**
   * Creates a session over an open channel.
   *
   * @param watchdog ends the other side if an answer takes too long
   * @param failures the failures of the other side
   */
  LockstepSession(HostChannel channel, Watchdog watchdog, HostFailures failures) {
    this.channel = channel;
    this.watchdog = watchdog;
    this.failures = failures;
  }

  @Override
  public JsonNode configure(JsonNode newConfiguration) {
    int kind = configuration == null ? HostChannel.CONFIGURE : HostChannel.RESET;
    configuration = newConfiguration;
    now = 0;
    commands = new ArrayList<>();
    byte[] payload = configuration.toString().getBytes(StandardCharsets.UTF_8);
    return json(ask(HostChannel.READY, () -> channel.send(kind, payload)));
  }

  @Override
  public List<Outbound> step(long until, List<Inbound> messages) {
    Frame frame = ask(HostChannel.STEPPED, () -> channel.sendStep(until, messages));
    List<Outbound> published = published(frame.payload());
    long earliest = now;
    for (Outbound command : published) {
      boolean known = command.topic() < configuration.path("world_subscribes").size();
      if (!known || command.time() < earliest || command.time() >= until) {
        throw failures.garbage("a message that cannot belong to this step");
      }
      earliest = command.time();
    }
    now = until;
    // Recorded sensor data would fill the memory.
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
      // handled below
    }
    throw failures.garbage("an answer to a step that is not as long as it says");
  }

  @Override
  public RunLog finish() {
    Frame frame = ask(HostChannel.FINISHED, () -> channel.send(HostChannel.FINISH, new byte[0]));
    try {
      RunLog log = RunLog.parse(json(frame));
      new RunLogCheck(log, configuration, now).check(commands);
      return log;
    } catch (IllegalArgumentException e) {
      throw failures.garbage("an invalid record of activations: " + e.getMessage());
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
      if (frame.kind() == HostChannel.FAILED) {
        throw failures.failed(json(frame));
      }
      if (frame.kind() != expected) {
        throw failures.garbage("a frame of kind " + frame.kind() + " instead of " + expected);
      }
      return frame;
    } catch (HostChannel.GarbageException e) {
      throw failures.garbage(e.getMessage());
    } catch (EOFException e) {
      throw failures.ended(watchdog.reason());
    } catch (IOException e) {
      throw failures.ended(
          watchdog.reason()); // a broken pipe: the other side has ended during the write
    } finally {
      watchdog.stop();
    }
  }

  private JsonNode json(Frame frame) {
    try {
      return JSON.readTree(new String(frame.bytes(), StandardCharsets.UTF_8));
    } catch (JsonProcessingException e) {
      throw failures.garbage("broken JSON: " + e.getOriginalMessage());
    }
  }
}
