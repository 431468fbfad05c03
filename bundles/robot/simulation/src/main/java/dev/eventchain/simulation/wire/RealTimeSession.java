package dev.eventchain.simulation.wire;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.dds.DdsParticipant;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.simulation.host.HostChannel;
import dev.eventchain.simulation.host.RunLogCheck;
import dev.eventchain.simulation.host.UserFiles;
import dev.eventchain.simulation.node.NodeLimits;
import dev.eventchain.simulation.wire.WireWorld.Arrived;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;

/**
 * Nodes on DDS in real time: scenario time is wall time, callbacks run when timers fire and samples
 * arrive, and take their actual time. No node waits for another; the delay of the world itself
 * behind the clock is measured.
 */
final class RealTimeSession extends DdsSession {

  /** Lead time for the announcement of the start to the processes. */
  private static final long LEAD = TimeUnit.MILLISECONDS.toNanos(200);

  private final List<Notice> notices = new ArrayList<>();
  private long start;
  private long overrun;

  RealTimeSession(
      List<NodeProcess> nodes,
      DdsParticipant participant,
      MessageCatalog catalog,
      UserFiles files,
      NodeLimits limits) {
    super(nodes, participant, catalog, files, limits);
  }

  @Override
  void describe(ObjectNode node) {
    node.put("execution_time_ms", 0.0); // nodes take their actual time
  }

  @Override
  boolean isInRealTime() {
    return true;
  }

  @Override
  void begin() {
    overrun = 0;
    start = System.nanoTime() + LEAD; // monotonic, as the nodes' clock
    nodes.forEach(node -> node.tell(HostChannel.START, start));
  }

  /** Returns the time since the start, in ns. */
  private long elapsed() {
    return System.nanoTime() - start;
  }

  @Override
  void pass(long until, List<Inbound> messages, List<Outbound> published) {
    waitFor(now);
    world.show(now);
    for (Inbound message : messages) {
      world.publish(message, Math.max(now, elapsed()));
    }
    measureOverrun(now); // publishing may have taken a while
    waitFor(until);
    measureOverrun(until);
    for (Arrived each : takeArrived()) {
      // Late messages are followed from now on, as by a vehicle.
      long time = Math.max(now, Math.min(each.sample().sourceTimestamp(), until - 1));
      published.add(new Outbound(time, each.reader(), ByteBuffer.wrap(each.sample().bytes())));
    }
  }

  private void measureOverrun(long due) {
    overrun = Math.max(overrun, elapsed() - due);
  }

  private void waitFor(long time) {
    for (long left = time - elapsed(); left > 0; left = time - elapsed()) {
      take(supervisor.await(now, Duration.ofNanos(left)));
    }
  }

  @Override
  void check(RunLogCheck check, List<Outbound> published) {
    check.checkInRealTime();
  }

  @Override
  void end() {
    nodes.forEach(NodeProcess::stop);
    settle();
  }

  @Override
  void notice(List<JsonNode> finished) {
    notices.clear();
    for (int node = 0; node < nodes.size(); node++) {
      overrun = Math.max(overrun, finished.get(node).required("late").asLong());
      for (JsonNode event : finished.get(node).path("events")) {
        String topic = event.path(1).asText();
        String name = nodes.get(node).name();
        notices.add(new Notice(event.path(0).asText(), name, topic, event.path(2).asLong()));
      }
    }
  }

  @Override
  public long overrun() {
    return overrun;
  }

  @Override
  public List<Notice> notices() {
    return List.copyOf(notices);
  }
}
