package dev.eventchain.simulation.verdict;

import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;

/**
 * A quantity over time.
 *
 * @param name of the quantity
 * @param unit of the values; 1 for a ratio
 * @param absence why it has no values; empty if it has some
 * @param values one for each time of the series, infinite or NaN where there is none
 * @param names the names of values, if they have any
 */
public record Curve(
    String name, String unit, String absence, List<Double> values, List<Name> names) {

  /** The error of a conversion of units, as a part of the number. */
  private static final double ROUNDING = 1e-12;

  /** The most that the error may be: whole numbers have others beside them. */
  private static final double MOST_ROUNDING = 0.25;

  /** A value with a name. */
  public record Name(double value, String name) {}

  /** Copies the lists. */
  public Curve {
    values = List.copyOf(values);
    names = List.copyOf(names);
  }

  /** Creates a curve of plain numbers. */
  public Curve(String name, String unit, String absence, List<Double> values) {
    this(name, unit, absence, values, List.of());
  }

  /** Returns the first name of a value. */
  public Optional<String> nameOf(double value) {
    return at(value, names, Name::value).stream().map(Name::name).findFirst();
  }

  /**
   * Returns those of some known values that a number is: equal ones or, without any, those that are
   * equal but for a conversion of units, or as floats.
   */
  public static <T> List<T> at(double number, List<T> known, ToDoubleFunction<T> value) {
    List<T> equal = known.stream().filter(it -> value.applyAsDouble(it) == number).toList();
    return equal.isEmpty()
        ? known.stream().filter(it -> areSame(value.applyAsDouble(it), number)).toList()
        : equal;
  }

  private static boolean areSame(double known, double number) {
    boolean isWhole = known == Math.rint(known);
    double rounding = Math.min(MOST_ROUNDING, ROUNDING * Math.max(1.0, Math.abs(known)));
    return Math.abs(known - number) <= rounding || (!isWhole && (float) known == (float) number);
  }
}
