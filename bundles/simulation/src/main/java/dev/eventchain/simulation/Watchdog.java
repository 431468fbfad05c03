package dev.eventchain.simulation;

import java.time.Duration;
import java.util.concurrent.locks.LockSupport;

/**
 * Ends something that takes too long. Starting and stopping cost next to nothing, since a step of a
 * simulation takes less than a millisecond; a thread of its own looks now and then.
 */
final class Watchdog implements AutoCloseable {

  private static final long LOOK_NANOS = 20_000_000L;
  private static final long NEVER = Long.MAX_VALUE;

  private final Duration limit;
  private final Runnable end;
  private volatile long started = NEVER;
  private volatile boolean fired;
  private volatile boolean closed;

  Watchdog(Duration limit, Runnable end) {
    this.limit = limit;
    this.end = end;
    Thread thread = new Thread(this::watch, "lock-step watchdog");
    thread.setDaemon(true);
    thread.start();
  }

  Duration limit() {
    return limit;
  }

  void start() {
    started = System.nanoTime();
  }

  void stop() {
    started = NEVER;
  }

  /** Whether it had to end something. */
  boolean hasFired() {
    return fired;
  }

  private void watch() {
    while (!closed && !fired) {
      LockSupport.parkNanos(LOOK_NANOS);
      long since = started;
      if (since != NEVER && System.nanoTime() - since > limit.toNanos()) {
        fired = true;
        end.run();
      }
    }
  }

  @Override
  public void close() {
    closed = true;
  }
}
