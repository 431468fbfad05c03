package dev.eventchain.ocl.evaluation;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.time.Duration;
import java.util.concurrent.atomic.AtomicLong;

/**
 * How much processor time evaluations may take, those of several threads together. On a machine
 * that is busy with other things, nothing takes more of it. What waits forever is ended by wall
 * time: a minute for each second, and ten at least, since a process of low priority may be given
 * less than a sixtieth of a processor. Thread-safe.
 */
public final class TimeBudget {

  /** What a limit is measured with. */
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

    /** Nanoseconds of a clock on the wall, from an arbitrary start. */
    long wall();

    /**
     * Nanoseconds for which a processor worked for the calling thread, from an arbitrary start;
     * wall time where Java cannot tell. A hundred times as expensive as {@link #wall}.
     */
    long processor();

    /** Loaded when a limit is first looked at closely, as it takes ten milliseconds. */
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
  private final AtomicLong used = new AtomicLong();
  private final AtomicLong started = new AtomicLong(NOT_STARTED);

  /** Of a budget and all its parts, so that a thread's time is taken once. */
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

  /** A budget for everything that is evaluated with it. */
  public static TimeBudget of(Duration processorTime) {
    return of("it takes", processorTime, Clock.SYSTEM);
  }

  /**
   * As {@link #of(Duration)}.
   *
   * @param purpose who takes the time, in words: {@code it takes}
   * @param clock what measures it
   */
  public static TimeBudget of(String purpose, Duration processorTime, Clock clock) {
    return new TimeBudget(purpose, processorTime, clock);
  }

  /** A budget for a part: what is taken of it is taken of this one, too. */
  public TimeBudget part(Duration processorTime) {
    return new TimeBudget(processorTime, this);
  }

  /**
   * Whether all of it has been used; what a thread uses is known some milliseconds later. Takes the
   * time of the calling thread from now on, until that asks another budget.
   */
  public boolean isSpent() {
    return !shortage().isEmpty();
  }

  /**
   * As {@link #isSpent}: what there is too little of, in words; empty while there is some of all.
   */
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
    if (used.get() >= nanos) {
      return purpose + " more than " + text(nanos) + " of processor time";
    }
    long waited = clock.wall() - started.get();
    boolean late = waited >= LEAST_WALL && waited / WALL_FACTOR >= nanos;
    return late ? purpose + " more than " + text(Math.max(LEAST_WALL, nanos * WALL_FACTOR)) : "";
  }

  /** Takes processor time. */
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
