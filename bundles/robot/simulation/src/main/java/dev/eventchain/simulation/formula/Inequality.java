package dev.eventchain.simulation.formula;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A comparison of a condition of one moment, whose negations are resolved: a sum is above 0.
 *
 * @param factors those of the signals in the sum, by their names, in coherent units; empty if the
 *     sum has parts that are no signals
 * @param constant the rest of the sum
 * @param strict false if the sum may also be 0
 * @param text as it is written
 */
public record Inequality(
    Optional<Map<String, Double>> factors, double constant, boolean strict, String text) {

  /** Number of alternatives beyond which nobody reads a condition any more. */
  private static final int MOST = 64;

  /** Returns the sums that have to be above 0, of which one list of all is enough. */
  static Optional<List<List<Inequality>>> alternatives(Condition condition) {
    List<List<Inequality>> all = resolved(condition, true);
    return all.size() > MOST ? Optional.empty() : Optional.of(all);
  }

  private static List<List<Inequality>> resolved(Condition condition, boolean holds) {
    if (condition instanceof Condition.Comparison comparison) {
      return List.of(List.of(of(comparison, holds)));
    }
    if (condition instanceof Condition.Negation negation) {
      return resolved(negation.operand(), !holds);
    }
    if (condition instanceof Condition.Implication implication) {
      List<List<Inequality>> premise = resolved(implication.premise(), !holds);
      List<List<Inequality>> conclusion = resolved(implication.conclusion(), holds);
      return holds ? either(premise, conclusion) : both(premise, conclusion);
    }
    if (condition instanceof Condition.Junction junction) {
      List<List<Inequality>> first = resolved(junction.first(), holds);
      List<List<Inequality>> second = resolved(junction.second(), holds);
      return junction.all() == holds ? both(first, second) : either(first, second);
    }
    throw new IllegalArgumentException("It is not about one moment.");
  }

  private static Inequality of(Condition.Comparison comparison, boolean holds) {
    Sum difference = comparison.difference();
    Sum above = holds ? difference : Sum.number(0.0).plus(difference, -1.0);
    return new Inequality(
        above.ofSignals(), above.number(), comparison.strict() == holds, comparison.text());
  }

  private static List<List<Inequality>> either(
      List<List<Inequality>> first, List<List<Inequality>> second) {
    List<List<Inequality>> all = new ArrayList<>(first);
    all.addAll(second);
    return all;
  }

  private static List<List<Inequality>> both(
      List<List<Inequality>> first, List<List<Inequality>> second) {
    List<List<Inequality>> all = new ArrayList<>();
    for (List<Inequality> one : first) {
      for (List<Inequality> other : second) {
        if (all.size() <= MOST) {
          List<Inequality> together = new ArrayList<>(one);
          together.addAll(other);
          all.add(together);
        }
      }
    }
    return all;
  }
}
