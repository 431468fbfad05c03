package dev.eventchain.simulation.formula;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/**
 * A quantity as a sum of parts with factors, so that what is subtracted from itself disappears.
 * Parts are signals, or expressions of which only the values are known.
 */
final class Sum {

  private final Map<Object, Double> factors = new LinkedHashMap<>();
  private final Map<Object, Range.Of> values = new LinkedHashMap<>();
  private double constant;

  private Sum() {}

  static Sum number(double number) {
    Sum sum = new Sum();
    sum.constant = number;
    return sum;
  }

  /**
   * Returns a part alone.
   *
   * @param part equal for equal parts
   */
  static Sum of(Object part, Range.Of range) {
    Sum sum = new Sum();
    sum.factors.put(part, 1.0);
    sum.values.put(part, range);
    return sum;
  }

  /** Returns this plus another one, with a factor. */
  Sum plus(Sum other, double factor) {
    Sum sum = number(constant + factor * other.constant);
    sum.factors.putAll(factors);
    sum.values.putAll(values);
    sum.values.putAll(other.values);
    other.factors.forEach((part, each) -> sum.factors.merge(part, factor * each, Double::sum));
    sum.factors.values().removeIf(each -> each == 0.0);
    return sum;
  }

  /** Returns whether it is the same number at all times. */
  boolean isNumber() {
    return factors.isEmpty();
  }

  /** Returns that number. */
  double number() {
    return constant;
  }

  /** Returns the factors by the names of signals; empty if there is another part than a signal. */
  Optional<Map<String, Double>> ofSignals() {
    Map<String, Double> named = new LinkedHashMap<>();
    for (Map.Entry<Object, Double> each : factors.entrySet()) {
      if (!(each.getKey() instanceof String signal)) {
        return Optional.empty();
      }
      named.put(signal, each.getValue());
    }
    return Optional.of(named);
  }

  /** Returns the only part, if it is the truth that a signal has a named value. */
  Optional<NamedPart> named() {
    return factors.size() == 1 && factors.keySet().iterator().next() instanceof NamedPart part
        ? Optional.of(part)
        : Optional.empty();
  }

  Range range(Range.Source signals) {
    Range range = new Range(constant, constant);
    for (Map.Entry<Object, Double> each : factors.entrySet()) {
      double factor = each.getValue();
      Range part = values.get(each.getKey()).apply(signals);
      range = range.plus(part.times(new Range(factor, factor)));
    }
    return range;
  }

  /** Returns the factor by which another one has to be multiplied to have the same parts; or 0. */
  double ratio(Sum other) {
    if (isNumber() || !factors.keySet().equals(other.factors.keySet())) {
      return 0.0;
    }
    Object first = factors.keySet().iterator().next();
    double ratio = factors.get(first) / other.factors.get(first);
    boolean same =
        factors.entrySet().stream()
            .allMatch(each -> each.getValue() == ratio * other.factors.get(each.getKey()));
    return same ? ratio : 0.0;
  }
}
