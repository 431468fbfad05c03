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

/**
 * Waits for what nodes say and for samples, and finds out who is to blame when nothing comes any
 * more.
 */
final class Supervisor {

  /** What it has to know of a node. */
  interface Watched {

    /** Its name. */
    String name();

    /** Whether it owes no answer. */
    boolean isIdle();

    /** Whether its process was stopped. */
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
   * Watches nodes.
   *
   * @param wallTime what a component may use for an answer; a node gets more
   */
  Supervisor(List<? extends Watched> nodes, UserFiles files, Duration wallTime) {
    this(nodes, files, wallTime.multipliedBy(2).plusSeconds(10), System::nanoTime);
  }

  /**
   * With another clock.
   *
   * @param patience how long a node that owes an answer may say nothing
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

  /** A node says something; from any thread. */
  void said(Said said) {
    events.add(said);
  }

  /** A sample; from any thread. */
  void arrived(Arrived sample) {
    events.add(sample);
  }

  /** A scenario starts: samples of the previous one no longer count. */
  void start() {
    events.removeIf(Arrived.class::isInstance);
    looked = clock.getAsLong();
    said = looked;
    arrived = looked;
  }

  /**
   * The next event, a {@link Said} or an {@link Arrived}; empty if there was none for a moment.
   *
   * @param deliveries what is underway; empty before anything is
   * @throws dev.eventchain.diagnostics.DiagnosticException if a node, or the wire, does not
   *     continue
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
   * The next event; empty if there was none in this time, which is nobody's fault unless a node was
   * stopped.
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
    if (silence > patience.toNanos()) { // samples of others are no sign of life of who owes one
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
