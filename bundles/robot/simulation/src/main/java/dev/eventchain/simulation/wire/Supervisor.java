package dev.eventchain.simulation.wire;

import dev.eventchain.simulation.host.UserFiles;
import dev.eventchain.simulation.wire.NodeProcess.Said;
import dev.eventchain.simulation.wire.WireWorld.Arrived;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;

/** Waits for output of nodes and for samples, and identifies the cause when none comes any more. */
final class Supervisor {

  /** Supervised view of a node. */
  interface Watched {

    /** Returns its name. */
    String name();

    /** Returns whether no answer is pending. */
    boolean isIdle();

    /** Returns whether its process was stopped. */
    boolean isStopped();
  }

  private static final Duration LOOK = Duration.ofMillis(200);
  private static final long STOPPED_NANOS = TimeUnit.SECONDS.toNanos(1);
  private static final long LOST_NANOS = TimeUnit.SECONDS.toNanos(20);

  private final BlockingQueue<Object> events = new LinkedBlockingQueue<>();
  private final List<? extends Watched> nodes;
  private final UserFiles files;
  private final Duration patience;
  private final LongSupplier clock;
  private long looked;
  private long said;
  private long arrived;

  /**
   * Creates a supervisor of nodes.
   *
   * @param wallTime time limit of a component for an answer; that of a node is longer
   */
  Supervisor(List<? extends Watched> nodes, UserFiles files, Duration wallTime) {
    this(nodes, files, wallTime.multipliedBy(2).plusSeconds(10), System::nanoTime);
  }

  /**
   * Creates a supervisor with another clock.
   *
   * @param patience maximum silence of a node with a pending answer
   * @param clock in ns
   */
  Supervisor(
      List<? extends Watched> nodes, UserFiles files, Duration patience, LongSupplier clock) {
    this.nodes = nodes;
    this.files = files;
    this.patience = patience;
    this.clock = clock;
    start();
  }

  /** Adds output of a node; from any thread. */
  void said(Said said) {
    events.add(said);
  }

  /** Adds a sample; from any thread. */
  void arrived(Arrived sample) {
    events.add(sample);
  }

  /** Starts a scenario; samples of the previous one no longer count. */
  void start() {
    events.removeIf(Arrived.class::isInstance);
    looked = clock.getAsLong();
    said = looked;
    arrived = looked;
  }

  /**
   * Returns the next event, a {@link Said} or an {@link Arrived}; empty if there was none for a
   * moment.
   *
   * @param deliveries samples on the way; empty before there are any
   * @throws dev.eventchain.diagnostics.DiagnosticException if a node, or DDS, does not continue
   */
  Optional<Object> await(long now, Optional<Deliveries> deliveries) {
    Optional<Object> event = poll(LOOK);
    if (clock.getAsLong() - looked >= LOOK.toNanos()) {
      looked = clock.getAsLong();
      blame(now, deliveries);
    }
    return event;
  }

  /**
   * Returns the next event; empty if there was none in this time, which is no failure unless a node
   * was stopped.
   */
  Optional<Object> await(long now, Duration time) {
    Optional<Object> event = poll(time.compareTo(LOOK) < 0 ? time : LOOK);
    if (clock.getAsLong() - looked > STOPPED_NANOS) {
      looked = clock.getAsLong();
      blameStopped(now);
    }
    return event;
  }

  private Optional<Object> poll(Duration time) {
    try {
      Object event = events.poll(time.toNanos(), TimeUnit.NANOSECONDS);
      if (event instanceof Said) {
        said = clock.getAsLong();
      } else if (event != null) {
        arrived = clock.getAsLong();
      }
      return Optional.ofNullable(event);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("interrupted while waiting for nodes", e);
    }
  }

  private void blame(long now, Optional<Deliveries> deliveries) {
    long silence = looked - said;
    if (silence > STOPPED_NANOS) {
      blameStopped(now);
    }
    if (silence > patience.toNanos()) { // samples of other nodes do not excuse a pending answer
      blameSilent(now);
    }
    long stillness = looked - Math.max(said, arrived);
    if (stillness > LOST_NANOS && nodes.stream().allMatch(Watched::isIdle)) {
      deliveries.ifPresent(Deliveries::giveUp);
    }
    List<String> waiting = deliveries.map(Deliveries::waitingTopics).orElse(List.of());
    if (stillness > patience.toNanos() && !waiting.isEmpty()) {
      throw NodeLoss.unreachable(waiting, now, files);
    }
  }

  private void blameSilent(long now) {
    for (Watched node : nodes) {
      if (!node.isIdle()) {
        throw NodeLoss.silent(node.name(), now, patience.toSeconds() + " s", files);
      }
    }
  }

  private void blameStopped(long now) {
    for (Watched node : nodes) {
      if (node.isStopped()) {
        throw NodeLoss.stopped(node.name(), now, files);
      }
    }
  }
}
