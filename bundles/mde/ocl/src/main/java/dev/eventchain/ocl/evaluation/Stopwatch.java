package dev.eventchain.ocl.evaluation;

/**
 * Takes the processor time of one thread from budgets, a little later than it is used: the clock
 * for that is expensive, so it is read only when so much wall time has gone by that it may matter.
 */
final class Stopwatch {

  /** A thread cannot use more processor time than wall time, so it reports late by this at most. */
  private static final long BETWEEN_READINGS = 20_000_000;

  private static final long UNKNOWN = Long.MIN_VALUE;

  private final TimeBudget.Clock clock;
  private TimeBudget budget;
  private long wall;
  private long processor = UNKNOWN;

  Stopwatch(TimeBudget.Clock clock) {
    this.clock = clock;
    this.wall = clock.wall();
  }

  /** Takes what has been used, and takes time from this budget from now on. */
  void charge(TimeBudget next) {
    long now = clock.wall();
    if (now - wall >= BETWEEN_READINGS) {
      wall = now;
      long reading = clock.processor();
      if (processor != UNKNOWN && budget != null) {
        budget.take(reading - processor);
      }
      processor = reading;
    }
    budget = next;
  }
}
