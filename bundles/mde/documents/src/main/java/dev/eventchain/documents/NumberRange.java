package dev.eventchain.documents;

/**
 * Range of allowed numbers.
 *
 * @param least the lower bound
 * @param above true if the lower bound is excluded
 * @param most the upper bound, included
 */
public record NumberRange(double least, boolean above, double most) {

  /** Returns a range with both bounds included. */
  public static NumberRange of(double least, double most) {
    return new NumberRange(least, false, most);
  }

  /** Returns the range of a number and all greater finite ones. */
  public static NumberRange atLeast(double least) {
    return new NumberRange(least, false, Double.POSITIVE_INFINITY);
  }

  /** Returns the range of all finite numbers greater than a number. */
  public static NumberRange above(double least) {
    return new NumberRange(least, true, Double.POSITIVE_INFINITY);
  }

  /** Returns this range with another upper bound. */
  public NumberRange upTo(double newMost) {
    return new NumberRange(least, above, newMost);
  }

  boolean holds(double number) {
    return Double.isFinite(number) && (above ? number > least : number >= least) && number <= most;
  }

  /** Returns the range in words: "from 0 to 5". */
  String words() {
    if (Double.isInfinite(most)) {
      String bound = least == 0 ? "zero" : plain(least);
      return "finite and " + (above ? "above " + bound : bound + " or more");
    }
    return above
        ? "above " + plain(least) + " and at most " + plain(most)
        : "from " + plain(least) + " to " + plain(most);
  }

  private static String plain(double number) {
    return number == Math.rint(number) && Math.abs(number) < 1e15
        ? String.valueOf((long) number)
        : String.valueOf(number);
  }
}
