package dev.eventchain.simulation;

import dev.eventchain.simulation.WireWorld.Arrived;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;

/**
 * Waits for what nodes say and for samples, and finds out who is to blame when nothing comes any
 * more.
 */
final class Supervisor {

  private static final Duration LOOK = Duration.ofMillis(200);
  private static final long STOPPED_NANOS = TimeUnit.SECONDS.toNanos(1);
  private static final long LOST_NANOS = TimeUnit.SECONDS.toNanos(20);

  private final BlockingQueue<Object> events = new LinkedBlockingQueue<>();
  private final Iterable<NodeProcess> nodes;
  private final UserFiles files;
  private final Duration patience;
  private long progress = System.nanoTime();
  private long looked = System.nanoTime();

  /**
   * Listens to nodes.
   *
   * @param wallTime what a component may use for an answer; a node gets more
   */
  Supervisor(Iterable<NodeProcess> nodes, UserFiles files, Duration wallTime) {
    this.nodes = nodes;
    this.files = files;
    this.patience = wallTime.multipliedBy(2).plusSeconds(10);
    nodes.forEach(node -> node.listen(events::add));
  }

  /** A sample; from any thread. */
  void arrived(Arrived sample) {
    events.add(sample);
  }

  /** A scenario starts: samples of the one before mean nothing any more. */
  void start() {
    events.removeIf(Arrived.class::isInstance);
    progress = System.nanoTime();
  }

  /**
   * The next event, a {@link NodeProcess.Said} or an {@link Arrived}; empty if there was none for a
   * moment.
   *
   * @param deliveries what is underway; empty before anything is
   * @throws dev.eventchain.diagnostics.DiagnosticException if a node, or the wire, does not go on
   */
  Optional<Object> await(long now, Optional<Deliveries> deliveries) {
    Optional<Object> event = poll(LOOK);
    if (event.isEmpty()) {
      blame(System.nanoTime() - progress, now, deliveries);
    }
    return event;
  }

  /**
   * The next event; empty if there was none in this time, which is nobody's fault unless a node was
   * stopped.
   */
  Optional<Object> await(long now, Duration time) {
    Optional<Object> event = poll(time.compareTo(LOOK) < 0 ? time : LOOK);
    if (System.nanoTime() - looked > STOPPED_NANOS) {
      looked = System.nanoTime();
      blameStopped(now);
    }
    return event;
  }

  private Optional<Object> poll(Duration time) {
    try {
      Object event = events.poll(time.toNanos(), TimeUnit.NANOSECONDS);
      if (event != null) {
        progress = System.nanoTime();
      }
      return Optional.ofNullable(event);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("interrupted while waiting for nodes", e);
    }
  }

  private void blame(long silence, long now, Optional<Deliveries> deliveries) {
    if (silence > STOPPED_NANOS) {
      blameStopped(now);
    }
    boolean idle = true;
    for (NodeProcess node : nodes) {
      idle &= node.isIdle();
      if (!node.isIdle() && silence > patience.toNanos()) {
        throw NodeLoss.silent(node, now, patience.toSeconds() + " s", files);
      }
    }
    if (idle && silence > LOST_NANOS) {
      deliveries.ifPresent(Deliveries::giveUp);
    }
    if (silence > patience.toNanos()) {
      throw NodeLoss.unreachable(
          deliveries.map(Deliveries::waitingTopics).orElse(List.of()), now, files);
    }
  }

  private void blameStopped(long now) {
    for (NodeProcess node : nodes) {
      if (node.isStopped()) {
        throw NodeLoss.stopped(node, now, files);
      }
    }
  }
}
