package dev.eventchain.simulation.strength;

import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;

/**
 * Trials within a budget of simulated time. One belongs to the round if those before it have taken
 * less than the budget; so the same ones do however many are driven at the same time.
 */
public final class TrialRound<T> {

  private final List<T> trials;
  private final ToDoubleFunction<T> seconds;
  private final int always;
  private final double budget;
  private final boolean[] ended;

  /**
   * Creates a round.
   *
   * @param trials the trials, in their order
   * @param seconds the simulated time of a trial that has ended
   * @param always the number of the first ones that belong to it in any case; their time counts
   * @param budget in s; may be infinite
   */
  TrialRound(List<T> trials, ToDoubleFunction<T> seconds, int always, double budget) {
    this.trials = List.copyOf(trials);
    this.seconds = seconds;
    this.always = always;
    this.budget = budget;
    this.ended = new boolean[trials.size()];
  }

  /** Returns the number of trials, with those that may not belong to it. */
  public int size() {
    return trials.size();
  }

  /**
   * Returns a trial to drive; empty if it is already clear that it does not belong to the round.
   * One that is driven may turn out not to, once those before it have ended.
   */
  public synchronized Optional<T> begin(int number) {
    return belongs(number) ? Optional.of(trials.get(number)) : Optional.empty();
  }

  /** Receives that a trial has ended. */
  public synchronized void end(int number) {
    ended[number] = true;
  }

  private boolean belongs(int number) {
    double before = 0;
    for (int i = 0; i < number; i++) {
      before += ended[i] ? seconds.applyAsDouble(trials.get(i)) : 0;
    }
    return number < always || before < budget;
  }

  /** Returns the trials that do not belong to the round, after all others have ended. */
  synchronized List<T> leftOut() {
    int first = 0;
    while (first < trials.size() && belongs(first)) {
      first++;
    }
    return trials.subList(first, trials.size());
  }
}
