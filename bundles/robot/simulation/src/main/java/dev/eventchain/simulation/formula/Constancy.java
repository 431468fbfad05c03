package dev.eventchain.simulation.formula;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/**
 * Finds conditions that are true, or false, in every run: from the values that signals can have,
 * and by trying all combinations of the comparisons in a condition. Parts with temporal operators
 * count as true or false independently of the rest. What it does not find may be constant as well.
 */
final class Constancy {

  /** Largest number of combinations that are tried. */
  private static final int MOST = 4096;

  private final Range.Source ranges;

  /** Comparisons of the same sum with numbers; the first one stands for the sum. */
  private final List<Condition.Comparison> sums = new ArrayList<>();

  private final IdentityHashMap<Condition, Integer> opaque = new IdentityHashMap<>();

  /** The values of the sums, and 1 or 0 for each opaque part, that are tried. */
  private final List<double[]> tried = new ArrayList<>();

  private Constancy(Range.Source ranges) {
    this.ranges = ranges;
  }

  /** Returns the truth of a condition in every run; empty if it may vary, or if that is unknown. */
  static Optional<Boolean> of(Condition condition, Range.Source ranges) {
    if (condition instanceof Condition.Comparison comparison) {
      return ofComparison(comparison, ranges);
    }
    if (condition instanceof Condition.Temporal || condition instanceof Past.Temporal) {
      return of(condition.parts().get(0), ranges);
    }
    Constancy constancy = new Constancy(ranges);
    return constancy.collect(condition) ? constancy.tried(condition) : Optional.empty();
  }

  private static Optional<Boolean> ofComparison(
      Condition.Comparison comparison, Range.Source ranges) {
    Range margin = comparison.difference().range(ranges);
    boolean strict = comparison.strict();
    if (strict ? margin.least() > 0.0 : margin.least() >= 0.0) {
      return Optional.of(true);
    }
    return (strict ? margin.most() <= 0.0 : margin.most() < 0.0)
        ? Optional.of(false)
        : Optional.empty();
  }

  /** Collects what the truth depends on; returns whether that is little enough. */
  private boolean collect(Condition condition) {
    if (condition instanceof Condition.Comparison comparison) {
      if (indexOf(comparison) < 0) {
        sums.add(comparison);
      }
    } else if (isPropositional(condition)) {
      condition.parts().forEach(this::collect);
    } else {
      opaque.putIfAbsent(condition, opaque.size());
    }
    return sums.size() + opaque.size() <= 12;
  }

  private static boolean isPropositional(Condition condition) {
    return condition instanceof Condition.Negation
        || condition instanceof Condition.Junction
        || condition instanceof Condition.Implication;
  }

  private int indexOf(Condition.Comparison comparison) {
    Sum difference = comparison.difference();
    Optional<String> named = comparison.named().map(it -> it.signal().name());
    for (int i = 0; i < sums.size(); i++) {
      Optional<String> other = sums.get(i).named().map(it -> it.signal().name());
      if (named.isPresent()
          ? named.equals(other)
          : sums.get(i).difference().ratio(difference) != 0.0) {
        return i;
      }
    }
    return -1;
  }

  private Optional<Boolean> tried(Condition condition) {
    long combinations = 1L << opaque.size();
    for (int i = 0; i < sums.size(); i++) {
      tried.add(candidates(condition, i));
      combinations *= tried.get(i).length;
    }
    if (combinations > MOST || combinations == 0) {
      return Optional.empty();
    }
    boolean first = truth(condition, 0);
    for (long each = 1; each < combinations; each++) {
      if (truth(condition, each) != first) {
        return Optional.empty();
      }
    }
    return Optional.of(first);
  }

  /**
   * Returns values of a sum: those at which comparisons change, and one between any two of them.
   */
  private double[] candidates(Condition condition, int index) {
    Optional<NamedPart> named = sums.get(index).named();
    if (named.isPresent()) {
      return named.get().signal().named().tried();
    }
    Range range = sums.get(index).difference().range(ranges);
    TreeSet<Double> changes = new TreeSet<>();
    changes(condition, index, changes);
    TreeSet<Double> found = new TreeSet<>(changes);
    found.add(changes.first() - 1.0);
    found.add(changes.last() + 1.0);
    Double before = null;
    for (double change : changes) {
      if (before != null) {
        found.add((before + change) / 2.0);
      }
      before = change;
    }
    addEnd(found, range.least());
    addEnd(found, range.most());
    return found.stream()
        .mapToDouble(Double::doubleValue)
        .filter(value -> value >= range.least() && value <= range.most())
        .toArray();
  }

  private static void addEnd(Set<Double> found, double end) {
    if (!Double.isInfinite(end)) {
      found.add(end);
    }
  }

  private void changes(Condition condition, int index, Set<Double> changes) {
    if (condition instanceof Condition.Comparison comparison) {
      if (indexOf(comparison) == index) {
        changes.add(valueAt(comparison, index));
      }
    } else if (isPropositional(condition)) {
      condition.parts().forEach(part -> changes(part, index, changes));
    }
  }

  /** Returns the value of a sum at which the sides of a comparison are equal. */
  private double valueAt(Condition.Comparison comparison, int index) {
    Sum sum = sums.get(index).difference();
    Sum other = comparison.difference();
    return sum.plus(other, -sum.ratio(other)).number();
  }

  private boolean truth(Condition condition, long combination) {
    if (condition instanceof Condition.Comparison comparison) {
      return truth(comparison, combination);
    }
    if (condition instanceof Condition.Negation negation) {
      return !truth(negation.operand(), combination);
    }
    if (condition instanceof Condition.Junction junction) {
      boolean first = truth(junction.first(), combination);
      boolean second = truth(junction.second(), combination);
      return junction.all() ? first && second : first || second;
    }
    if (condition instanceof Condition.Implication implication) {
      return !truth(implication.premise(), combination)
          || truth(implication.conclusion(), combination);
    }
    return ((combination >> opaque.get(condition)) & 1) == 1;
  }

  private boolean truth(Condition.Comparison comparison, long combination) {
    int index = indexOf(comparison);
    long rest = combination >> opaque.size();
    for (int i = 0; i < index; i++) {
      rest /= tried.get(i).length;
    }
    double value = tried.get(index)[(int) (rest % tried.get(index).length)];
    Optional<NamedPart> named = comparison.named();
    if (named.isPresent()) {
      boolean isAbove = comparison.left().signals().isEmpty();
      return isAbove == (named.get().of(value) > 0.5);
    }
    double ratio = sums.get(index).difference().ratio(comparison.difference());
    double margin = (value - valueAt(comparison, index)) / ratio;
    return comparison.strict() ? margin > 0.0 : margin >= 0.0;
  }
}
