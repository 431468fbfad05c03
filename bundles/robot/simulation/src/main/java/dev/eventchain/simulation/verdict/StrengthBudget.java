package dev.eventchain.simulation.verdict;

import java.util.function.ToDoubleFunction;

/**
 * The simulated time for the measurement of strength. It counts what is driven and not what that
 * takes, so that the same faults are driven on each machine.
 *
 * @param seconds the simulated time after which no further fault is driven; infinite for all faults
 * @param minimum the least part of its faults that a requirement has to notice, in percent, by
 *     identifier: one that stays below it in a sample gets all of its faults driven
 */
public record StrengthBudget(double seconds, ToDoubleFunction<String> minimum) {

  /** The budget where a project states no other one, in s. */
  public static final double USUAL = 600;

  /** Refuses a budget for nothing. */
  public StrengthBudget {
    if (!(seconds > 0)) {
      throw new IllegalArgumentException("a budget needs time");
    }
  }
}
