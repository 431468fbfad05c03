package dev.eventchain.simulation.host;

import java.time.Duration;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Supplier;

/**
 * Ends a task that takes too long: more processor time than allowed or, since waiting uses none,
 * far more wall time. Starting and stopping are cheap, since a step of a simulation takes less than
 * a millisecond; a separate thread polls.
 */
final class Watchdog implements AutoCloseable {

  private static final long LOOK_NANOS = 20_000_000L;

  /** Time before processor time is first polled, which is slow. */
  private static final long FIRST_LOOK_NANOS = 500_000_000L;

  private static final long NEVER = Long.MAX_VALUE;

  private final Duration processorTime;
  private final Duration wallTime;
  private final Supplier<Duration> clock;
  private final Runnable end;
  private volatile long started = NEVER;
  private volatile String reason = "";
  private volatile boolean closed;

  /**
   * Starts to watch.
   *
   * @param clock processor time used so far
   * @param end ends the task; run once
   */
  Watchdog(Duration processorTime, Duration wallTime, Supplier<Duration> clock, Runnable end) {
    this.processorTime = processorTime;
    this.wallTime = wallTime;
    this.clock = clock;
    this.end = end;
    Thread thread = new Thread(this::watch, "lock-step watchdog");
    thread.setDaemon(true);
    thread.start();
  }

  void start() {
    started = System.nanoTime();
  }

  void stop() {
    started = NEVER;
  }

  /** Returns the exceeded limit, for users; empty if there is none. */
  String reason() {
    return reason;
  }

  private void watch() {
    long watched = NEVER;
    Duration before = Duration.ZERO;
    while (!closed && reason.isEmpty()) {
      LockSupport.parkNanos(LOOK_NANOS);
      long since = started;
      if (since == NEVER || System.nanoTime() - since < FIRST_LOOK_NANOS) {
        continue;
      }
      if (since != watched) {
        watched = since;
        before = clock.get();
      } else if (clock.get().minus(before).compareTo(processorTime) > 0) {
        fire(processorTime.toSeconds() + " s of processor time");
      } else if (System.nanoTime() - since > wallTime.toNanos()) {
        fire(wallTime.toSeconds() + " s");
      }
    }
  }

  private void fire(String usedUp) {
    reason = usedUp;
    end.run();
  }

  @Override
  public void close() {
    closed = true;
  }
}
