package dev.eventchain.ocl.evaluation;

/**
 * Charges the processor time of one thread to budgets, with a small delay: the processor clock is
 * expensive, so it is read only after enough wall time.
 */
final class Stopwatch {

  /** Wall time between readings in nanoseconds, and so the largest delay of a charge. */
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

  /** Charges the time used so far, and charges this budget from now on. */
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
