package dev.eventchain.simulation.wire;

import dev.eventchain.dds.DdsParticipant;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.simulation.host.HostChannel;
import dev.eventchain.simulation.host.RunLogCheck;
import dev.eventchain.simulation.host.UserFiles;
import dev.eventchain.simulation.node.NodeLimits;
import dev.eventchain.simulation.wire.NodeProcess.Next;
import dev.eventchain.simulation.wire.WireWorld.Arrived;
import java.nio.ByteBuffer;
import java.util.Comparator;
import java.util.List;

/**
 * Nodes on DDS in simulated time, as a conservative simulation (Chandy and Misra). Time advances to
 * the next event of any node, and only when every written sample has arrived. At one instant,
 * samples are written and received first; then timers fire, in the order of their nodes, as in
 * lock-step. The result does not depend on the speed of the machine.
 */
final class SimulatedTimeSession extends DdsSession {

  SimulatedTimeSession(
      List<NodeProcess> nodes,
      DdsParticipant participant,
      MessageCatalog catalog,
      UserFiles files,
      NodeLimits limits) {
    super(nodes, participant, catalog, files, limits);
  }

  @Override
  void begin() {
    world.show(0);
    nodes.forEach(node -> node.let(HostChannel.PUBLISH, 0));
  }

  @Override
  void pass(long until, List<Inbound> messages, List<Outbound> published) {
    settle(published);
    world.show(now);
    messages.forEach(message -> world.publish(message, now));
    settle(published);
    for (Next next = next(); next.time() < until; next = next()) {
      if (next.time() > now) {
        now = next.time();
        world.show(now);
      }
      let(next);
      settle(published);
    }
  }

  /**
   * Lets nodes proceed; timers of one instant fire in the order of their nodes, since samples may
   * arrive at once.
   */
  private void let(Next next) {
    List<NodeProcess> due = nodes.stream().filter(it -> it.next(now).equals(next)).toList();
    if (next.runs()) {
      due.get(0).let(HostChannel.RUN, now);
    } else {
      due.forEach(node -> node.let(HostChannel.PUBLISH, now));
    }
  }

  private Next next() {
    return nodes.stream().map(node -> node.next(now)).min(Comparator.naturalOrder()).orElseThrow();
  }

  /** Waits until all nodes are idle, and all written samples have arrived. */
  private void settle(List<Outbound> published) {
    settle();
    for (Arrived each : takeArrived()) {
      published.add(new Outbound(now, each.reader(), ByteBuffer.wrap(each.sample().bytes())));
    }
  }

  @Override
  void check(RunLogCheck check, List<Outbound> published) {
    check.check(published);
  }
}
