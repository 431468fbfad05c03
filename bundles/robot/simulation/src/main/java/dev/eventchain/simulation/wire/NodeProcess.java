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
 * A node in a confined process of its own, with its last answer. A thread reads its output;
 * everything else belongs to the thread that drives the nodes.
 */
final class NodeProcess implements Supervisor.Watched, AutoCloseable {

  /**
   * Output of a node: a frame, or, without one, the reason for the end of its output.
   *
   * @param frame null at the end
   */
  record Said(NodeProcess node, Frame frame, String garbage) {}

  /**
   * Time of the next event in a node, in ns.
   *
   * @param runs true for a timer; false if samples are published or received
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

  /** Passes on the output of the node until it ends. */
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

  /** Returns whether it was stopped, with SIGSTOP for example. */
  @Override
  public boolean isStopped() {
    return process.isStopped();
  }

  /** Sends JSON; the answer is a frame of another kind. */
  void ask(int kind, JsonNode content, int answer) {
    awaited = answer;
    send(() -> channel.send(kind, content.toString().getBytes(StandardCharsets.UTF_8)));
  }

  /** Discards the output of the previous scenario. */
  void reset(int writers, int readers) {
    asked = 0;
    answered = 0;
    next = NEVER;
    hasSamples = false;
    written = new long[writers];
    received = new long[readers];
  }

  /** Makes it publish or run callbacks; it answers after that. */
  void let(int kind, long time) {
    asked++;
    tell(kind, time);
  }

  /** Stops its work for good, in real time; it confirms. */
  void stop() {
    asked++;
    send(() -> channel.send(HostChannel.STOP, new byte[0]));
  }

  /** Sends it a time, without an answer. */
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
      // The reading thread notices its end, too, and knows its previous output.
    }
  }

  /**
   * Processes its output.
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

  /** Returns its answer to the last request, once it is idle. */
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

  /** Returns whether it has answered all requests. */
  @Override
  public boolean isIdle() {
    return answered == asked && awaited == NOTHING;
  }

  /** Returns its next event, not before this time. */
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
