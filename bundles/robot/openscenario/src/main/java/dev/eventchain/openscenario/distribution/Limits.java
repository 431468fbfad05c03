package dev.eventchain.openscenario.distribution;

/**
 * The range that values are drawn from; both ends belong to it.
 *
 * @param lower the lower end, which may be infinite
 * @param upper the upper end likewise
 */
public record Limits(double lower, double upper) {

  /** All numbers. */
  public static final Limits NONE = new Limits(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);

  boolean contain(double value) {
    return value >= lower && value <= upper;
  }
}
