package dev.eventchain.documents;

/**
 * Which numbers are allowed.
 *
 * @param least the least one
 * @param above whether the least one itself cannot be
 * @param most the greatest one, which can be
 */
public record NumberRange(double least, boolean above, double most) {

  /** From one number to another, both included. */
  public static NumberRange of(double least, double most) {
    return new NumberRange(least, false, most);
  }

  /** A number and all finite ones beyond it. */
  public static NumberRange atLeast(double least) {
    return new NumberRange(least, false, Double.POSITIVE_INFINITY);
  }

  /** All finite numbers beyond a number. */
  public static NumberRange above(double least) {
    return new NumberRange(least, true, Double.POSITIVE_INFINITY);
  }

  /** The same range, up to a number. */
  public NumberRange upTo(double newMost) {
    return new NumberRange(least, above, newMost);
  }

  boolean holds(double number) {
    return Double.isFinite(number) && (above ? number > least : number >= least) && number <= most;
  }

  /** What a number has to be: "from 0 to 5". */
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
