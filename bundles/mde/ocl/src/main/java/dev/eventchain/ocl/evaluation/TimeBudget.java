package dev.eventchain.ocl.evaluation;

import dev.eventchain.diagnostics.Cancellation;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.time.Duration;
import java.util.concurrent.atomic.AtomicLong;

/**
 * A budget of processor time for evaluations, shared by several threads; it does not depend on the
 * load of the machine. Endless waits end by wall time: a minute for each second, and ten at least,
 * since a process of low priority may get less than a sixtieth of a processor. It is spent, too,
 * once the work that it was made in is cancelled. Thread-safe.
 */
public final class TimeBudget {

  /** The clocks that limits are measured with. */
  public interface Clock {

    /** The clocks of this machine. */
    Clock SYSTEM =
        new Clock() {
          @Override
          public long wall() {
            return System.nanoTime();
          }

          @Override
          public long processor() {
            long nanos = Processor.BEAN == null ? -1 : Processor.BEAN.getCurrentThreadCpuTime();
            return nanos < 0 ? wall() : nanos;
          }
        };

    /** Returns the wall time in nanoseconds from an arbitrary start. */
    long wall();

    /**
     * Returns the processor time of the calling thread in nanoseconds from an arbitrary start; wall
     * time if Java cannot measure it. A hundred times as expensive as {@link #wall}.
     */
    long processor();

    /** Loaded when the processor time is first read, which takes ten milliseconds. */
    final class Processor {
      private static final ThreadMXBean BEAN = find();

      private Processor() {}

      private static ThreadMXBean find() {
        ThreadMXBean bean = ManagementFactory.getThreadMXBean();
        return bean.isCurrentThreadCpuTimeSupported() && bean.isThreadCpuTimeEnabled()
            ? bean
            : null;
      }
    }
  }

  private static final int WALL_FACTOR = 60;
  private static final long LEAST_WALL = Duration.ofMinutes(10).toNanos();
  private static final long NOT_STARTED = Long.MIN_VALUE;

  private final String purpose;
  private final long nanos;
  private final TimeBudget whole;
  private final Clock clock;
  private final Cancellation cancellation = Cancellation.current();
  private final AtomicLong used = new AtomicLong();
  private final AtomicLong started = new AtomicLong(NOT_STARTED);

  /** Shared by a budget and all its parts, so that a thread's time is charged once. */
  private final ThreadLocal<Stopwatch> stopwatch;

  private TimeBudget(String purpose, Duration limit, Clock clock) {
    this.purpose = purpose;
    this.nanos = limit.toNanos();
    this.whole = null;
    this.clock = clock;
    this.stopwatch = ThreadLocal.withInitial(() -> new Stopwatch(clock));
  }

  private TimeBudget(Duration limit, TimeBudget whole) {
    this.purpose = "it takes";
    this.nanos = limit.toNanos();
    this.whole = whole;
    this.clock = whole.clock;
    this.stopwatch = whole.stopwatch;
  }

  /** Returns a budget for all evaluations that use it. */
  public static TimeBudget of(Duration processorTime) {
    return of("it takes", processorTime, Clock.SYSTEM);
  }

  /**
   * As {@link #of(Duration)}.
   *
   * @param purpose the subject and verb of messages: {@code it takes}
   * @param clock the clock
   */
  public static TimeBudget of(String purpose, Duration processorTime, Clock clock) {
    return new TimeBudget(purpose, processorTime, clock);
  }

  /** Returns a budget for a part, whose time is also charged to this one. */
  public TimeBudget part(Duration processorTime) {
    return new TimeBudget(processorTime, this);
  }

  /**
   * Returns whether the budget is spent, with a delay of some milliseconds per thread. Charges the
   * time of the calling thread from now on, until that calls another budget.
   */
  public boolean isSpent() {
    return !shortage().isEmpty();
  }

  /** As {@link #isSpent}, but returns the exceeded limit in words; empty if not spent. */
  public String shortage() {
    start();
    stopwatch.get().charge(this);
    String lack = lack();
    return whole == null || !lack.isEmpty() ? lack : whole.lack();
  }

  private void start() {
    if (started.get() == NOT_STARTED) {
      started.compareAndSet(NOT_STARTED, clock.wall());
      if (whole != null) {
        whole.start();
      }
    }
  }

  private String lack() {
    if (cancellation.isRequested()) {
      return "it is not wanted any more";
    } else if (used.get() >= nanos) {
      return purpose + " more than " + text(nanos) + " of processor time";
    }
    long waited = clock.wall() - started.get();
    boolean late = waited >= LEAST_WALL && waited / WALL_FACTOR >= nanos;
    return late ? purpose + " more than " + text(Math.max(LEAST_WALL, nanos * WALL_FACTOR)) : "";
  }

  /** Charges processor time. */
  void take(long processorNanos) {
    used.addAndGet(processorNanos);
    if (whole != null) {
      whole.take(processorNanos);
    }
  }

  private static String text(long nanos) {
    long millis = nanos / 1_000_000;
    return millis % 1000 == 0 ? millis / 1000 + " s" : millis + " ms";
  }
}
