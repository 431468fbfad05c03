package dev.eventchain.simulation.formula;

import java.util.function.Function;
import java.util.stream.DoubleStream;

/**
 * All values that a quantity can have, in coherent units; both ends belong to it.
 *
 * @param least the smallest value; may be infinite
 * @param most the largest value; may be infinite
 */
public record Range(double least, double most) {

  /** Every value. */
  public static final Range ALL = new Range(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);

  /** Ranges of signals, by their names; {@link #ALL} where nothing is known. */
  public interface Source extends Function<String, Range> {}

  /** Values of an expression, from those of the signals. */
  interface Of extends Function<Source, Range> {}

  /** Returns the range from 0 to a number. */
  public static Range upTo(double most) {
    return new Range(0.0, most);
  }

  /** Returns the range from the negative of a number to that number. */
  public static Range within(double most) {
    return new Range(-most, most);
  }

  Range plus(Range other) {
    return new Range(sum(least, other.least, ALL.least), sum(most, other.most, ALL.most));
  }

  /** Adds, where the sum of opposite infinities is unknown. */
  private static double sum(double one, double other, double unknown) {
    double sum = one + other;
    return Double.isNaN(sum) ? unknown : sum;
  }

  Range times(Range other) {
    return hull(
        product(least, other.least),
        product(least, other.most),
        product(most, other.least),
        product(most, other.most));
  }

  private static double product(double one, double other) {
    return one == 0.0 || other == 0.0 ? 0.0 : one * other;
  }

  /** Returns the quotient; every value if the divisor may be 0. */
  Range by(Range divisor) {
    return divisor.least > 0.0 || divisor.most < 0.0
        ? times(new Range(1.0 / divisor.most, 1.0 / divisor.least))
        : ALL;
  }

  Range absolute() {
    double largest = Math.max(Math.abs(least), Math.abs(most));
    return least <= 0.0 && most >= 0.0
        ? upTo(largest)
        : new Range(Math.min(Math.abs(least), Math.abs(most)), largest);
  }

  /** Returns the range from one end to the other, both rounded up to a whole number. */
  Range ceiling() {
    return new Range(Math.ceil(least), Math.ceil(most));
  }

  /** Returns the smallest range with both. */
  Range union(Range other) {
    return new Range(Math.min(least, other.least), Math.max(most, other.most));
  }

  Range minimum(Range other) {
    return new Range(Math.min(least, other.least), Math.min(most, other.most));
  }

  Range maximum(Range other) {
    return new Range(Math.max(least, other.least), Math.max(most, other.most));
  }

  private static Range hull(double... ends) {
    return new Range(
        DoubleStream.of(ends).min().orElseThrow(), DoubleStream.of(ends).max().orElseThrow());
  }
}
