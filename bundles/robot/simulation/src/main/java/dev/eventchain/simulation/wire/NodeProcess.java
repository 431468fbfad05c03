package dev.eventchain.simulation.wire;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.sandbox.ConfinedProcess;
import dev.eventchain.sandbox.WorkFolder;
import dev.eventchain.simulation.host.HostChannel;
import dev.eventchain.simulation.host.HostChannel.Frame;
import dev.eventchain.simulation.host.HostFailures;
import dev.eventchain.simulation.host.UserFiles;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.function.Consumer;

/**
 * A node in a confined process of its own, with what it said last. A thread reads what it says;
 * everything else belongs to the thread that drives the nodes.
 */
final class NodeProcess implements Supervisor.Watched, AutoCloseable {

  /**
   * What a node said: a frame, or, if it has none, why there are no more.
   *
   * @param frame null at the end
   */
  record Said(NodeProcess node, Frame frame, String garbage) {}

  /**
   * When something happens next in a node, in ns.
   *
   * @param runs whether it is a timer; else samples are published or received
   */
  record Next(long time, boolean runs) implements Comparable<Next> {
    @Override
    public int compareTo(Next other) {
      int order = Long.compare(time, other.time);
      return order != 0 ? order : Boolean.compare(runs, other.runs);
    }
  }

  private static final ObjectMapper JSON = new ObjectMapper();
  private static final int NOTHING = 0;
  private static final Next NEVER = new Next(Long.MAX_VALUE, true);

  private final String name;
  private final ConfinedProcess process;
  private final WorkFolder workFolder;
  private final HostChannel channel;
  private final HostFailures failures;
  private JsonNode answer;
  private long asked;
  private long answered;
  private int awaited = NOTHING;
  private Next next = NEVER;
  private boolean hasSamples;
  private long[] written = {};
  private long[] received = {};

  NodeProcess(String name, ConfinedProcess process, WorkFolder workFolder, UserFiles files) {
    this.name = name;
    this.process = process;
    this.workFolder = workFolder;
    this.channel = new HostChannel(process.stdout(), process.stdin());
    this.failures =
        new HostFailures(
            "The process of node " + name, () -> HostFailures.LastWords.of(process), files);
  }

  /** Hands on all that the node says, until it ends. */
  void listen(Consumer<Said> listener) {
    Thread thread = new Thread(() -> read(listener), "node " + name);
    thread.setDaemon(true);
    thread.start();
  }

  private void read(Consumer<Said> listener) {
    try {
      while (true) {
        listener.accept(new Said(this, channel.receive(), ""));
      }
    } catch (HostChannel.GarbageException e) {
      listener.accept(new Said(this, null, e.getMessage()));
    } catch (IOException e) {
      listener.accept(new Said(this, null, ""));
    }
  }

  @Override
  public String name() {
    return name;
  }

  HostFailures failures() {
    return failures;
  }

  /** Whether it was stopped, with SIGSTOP for example. */
  @Override
  public boolean isStopped() {
    return process.isStopped();
  }

  /** Sends JSON; it answers with a frame of another kind. */
  void ask(int kind, JsonNode content, int answer) {
    awaited = answer;
    send(() -> channel.send(kind, content.toString().getBytes(StandardCharsets.UTF_8)));
  }

  /** Forgets what it said of the scenario before. */
  void reset(int writers, int readers) {
    asked = 0;
    answered = 0;
    next = NEVER;
    hasSamples = false;
    written = new long[writers];
    received = new long[readers];
  }

  /** Lets it publish, or run callbacks; it answers when that is done. */
  void let(int kind, long time) {
    asked++;
    tell(kind, time);
  }

  /** In real time, stops its work for good; it answers when it has heard that. */
  void stop() {
    asked++;
    send(() -> channel.send(HostChannel.STOP, new byte[0]));
  }

  /** Tells it a time; it answers nothing. */
  void tell(int kind, long time) {
    send(() -> channel.sendTime(kind, time));
  }

  private interface Sending {
    void send() throws IOException;
  }

  private void send(Sending sending) {
    try {
      sending.send();
    } catch (IOException e) {
      // The thread that reads sees its end, too, and knows what it said before.
    }
  }

  /**
   * Takes in what it said.
   *
   * @throws DiagnosticException if it failed, has ended, or broke the protocol
   */
  void take(Said said) {
    if (said.frame() == null) {
      throw said.garbage().isEmpty() ? failures.ended("") : failures.garbage(said.garbage());
    }
    int kind = said.frame().kind();
    switch (kind) {
      case HostChannel.FAILED -> throw failures.failed(json(said.frame()));
      case HostChannel.IDLE -> idle(json(said.frame()));
      case HostChannel.READY, HostChannel.CONNECTED, HostChannel.FINISHED -> answered(said.frame());
      default -> throw failures.garbage("a frame of kind " + kind);
    }
  }

  private void answered(Frame frame) {
    if (frame.kind() != awaited) {
      throw failures.garbage("an unexpected answer of kind " + frame.kind());
    }
    awaited = NOTHING;
    answer = json(frame);
  }

  /** What it answered to what it was asked last, once it is idle. */
  JsonNode answer() {
    return answer;
  }

  private void idle(JsonNode said) {
    try {
      answered = said.required("answered").asLong();
      JsonNode event = said.required("next");
      next = event.isNull() ? NEVER : new Next(event.get(0).asLong(), event.get(1).asBoolean());
      hasSamples = said.required("samples").asBoolean();
      copy(said.required("wrote"), written);
      copy(said.required("read"), received);
    } catch (IllegalArgumentException e) {
      throw failures.garbage("an invalid IDLE frame");
    }
  }

  private static void copy(JsonNode counts, long[] to) {
    if (counts.size() != to.length) {
      throw new IllegalArgumentException("other ends");
    }
    for (int i = 0; i < to.length; i++) {
      to[i] = counts.get(i).asLong();
    }
  }

  private JsonNode json(Frame frame) {
    try {
      return JSON.readTree(new String(frame.bytes(), StandardCharsets.UTF_8));
    } catch (JsonProcessingException e) {
      throw failures.garbage("broken JSON: " + e.getOriginalMessage());
    }
  }

  /** Whether it has answered everything. */
  @Override
  public boolean isIdle() {
    return answered == asked && awaited == NOTHING;
  }

  /** What comes next, not before this time. */
  Next next(long now) {
    Next own = next.time() < now ? new Next(now, next.runs()) : next;
    Next samples = new Next(now, false);
    return hasSamples && samples.compareTo(own) < 0 ? samples : own;
  }

  long written(int writer) {
    return written[writer];
  }

  long received(int reader) {
    return received[reader];
  }

  @Override
  public void close() {
    process.close();
    workFolder.close();
  }
}
