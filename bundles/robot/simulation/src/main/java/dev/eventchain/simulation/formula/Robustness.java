package dev.eventchain.simulation.formula;

/**
 * Truth with a margin, in one number: positive if true, negative if false, and zero if unknown. The
 * size is the distance of the compared values from a change of the verdict (the robustness of
 * Signal Temporal Logic). If both values are equal, the margin is zero but the verdict is exact: it
 * is the sign of the smallest representable number. Thus {@code not}, {@code and} and {@code or}
 * are the negative, the minimum and the maximum, both of Kleene's three-valued logic and of the
 * margins.
 */
final class Robustness {

  static final double UNKNOWN = 0.0;
  private static final double NO_MARGIN = Double.MIN_VALUE;

  private Robustness() {}

  /** Returns whether one value is less than another or, in a non-strict comparison, equal to it. */
  static double less(double smaller, double larger, boolean strict) {
    if (Double.isNaN(smaller) || Double.isNaN(larger)) {
      return UNKNOWN;
    }
    if (smaller == larger) {
      return strict ? -NO_MARGIN : NO_MARGIN;
    }
    return larger - smaller;
  }

  /** Returns the margin without its sign. */
  static double margin(double truth) {
    double size = Math.abs(truth);
    return size == NO_MARGIN ? 0.0 : size;
  }

  static double[] not(double[] values) {
    double[] negatives = new double[values.length];
    for (int i = 0; i < values.length; i++) {
      negatives[i] = -values[i];
    }
    return negatives;
  }

  static double[] and(double[] first, double[] second) {
    double[] least = new double[first.length];
    for (int i = 0; i < least.length; i++) {
      least[i] = Math.min(first[i], second[i]);
    }
    return least;
  }

  static double[] or(double[] first, double[] second) {
    return not(and(not(first), not(second)));
  }

  /**
   * Returns whether the condition is true at some sample of the interval, for each sample.
   *
   * @param cut true if an interval without a bound reaches beyond the last sample
   */
  static double[] eventually(double[] values, Interval interval, boolean cut) {
    if (!interval.bounded()) {
      return eventuallyUntilTheEnd(values, cut);
    }
    int size = values.length;
    double[] result = new double[size];
    // Indices of the window's samples by decreasing value, for a sliding maximum.
    int[] candidates = new int[size];
    int first = 0;
    int end = 0;
    for (int i = size - 1; i >= 0; i--) {
      int entering = i + interval.from();
      if (entering < size) {
        while (end > first && values[candidates[end - 1]] <= values[entering]) {
          end--;
        }
        candidates[end++] = entering;
      }
      while (end > first && candidates[first] > i + interval.to()) {
        first++;
      }
      double most = end > first ? values[candidates[first]] : Double.NEGATIVE_INFINITY;
      result[i] = i + interval.to() < size ? most : Math.max(most, UNKNOWN);
    }
    return result;
  }

  private static double[] eventuallyUntilTheEnd(double[] values, boolean cut) {
    double[] result = values.clone();
    int last = values.length - 1;
    result[last] = cut ? Math.max(values[last], UNKNOWN) : values[last];
    for (int i = values.length - 2; i >= 0; i--) {
      result[i] = Math.max(values[i], result[i + 1]);
    }
    return result;
  }

  static double[] always(double[] values, Interval interval, boolean cut) {
    return not(eventually(not(values), interval, cut));
  }

  /**
   * Returns whether the second is true at a sample in the interval and the first at all samples
   * before it. This equals: the second is true in the interval at all, and the first holds until
   * the second at any time. Each of the two takes one pass.
   */
  static double[] until(double[] first, double[] second, Interval interval, boolean cut) {
    int size = first.length;
    double[] whenever = new double[size];
    double after = interval.bounded() || cut ? UNKNOWN : Double.NEGATIVE_INFINITY;
    for (int i = size - 1; i >= 0; i--) {
      after = Math.max(second[i], Math.min(first[i], after));
      whenever[i] = after;
    }
    if (!interval.bounded()) {
      return whenever;
    }
    int from = interval.from();
    double[] soon = eventually(second, new Interval(0, interval.to() - from, true), cut);
    double[] fromThere = and(whenever, soon);
    if (from == 0) {
      return fromThere;
    }
    double[] shifted = new double[size];
    for (int i = 0; i + from < size; i++) {
      shifted[i] = fromThere[i + from];
    }
    return and(always(first, new Interval(0, from - 1, true), cut), shifted);
  }

  /**
   * Returns whether the condition was true at some sample of the interval before each sample;
   * unknown where the whole interval is before the first sample.
   */
  static double[] once(double[] values, Interval interval) {
    int size = values.length;
    double[] result = new double[size];
    // Indices of the window's samples by decreasing value, for a sliding maximum.
    int[] candidates = new int[size];
    int first = 0;
    int end = 0;
    for (int i = 0; i < size; i++) {
      int entering = i - interval.from();
      if (entering >= 0) {
        while (end > first && values[candidates[end - 1]] <= values[entering]) {
          end--;
        }
        candidates[end++] = entering;
      }
      while (interval.bounded() && end > first && candidates[first] < i - interval.to()) {
        first++;
      }
      result[i] = end > first ? values[candidates[first]] : UNKNOWN;
    }
    return result;
  }

  /**
   * Returns whether the second was true at a sample of the interval before each sample, and the
   * first at all samples after that one; unknown where the whole interval is before the first
   * sample. See {@link #until}, whose mirror image it is.
   */
  static double[] since(double[] first, double[] second, Interval interval) {
    int size = first.length;
    double[] whenever = new double[size];
    double before = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < size; i++) {
      before = Math.max(second[i], Math.min(first[i], before));
      whenever[i] = before;
    }
    if (!interval.bounded()) {
      return whenever;
    }
    int from = interval.from();
    double[] there = and(whenever, once(second, new Interval(0, interval.to() - from, true)));
    if (from == 0) {
      return there;
    }
    double[] kept = not(once(not(first), new Interval(0, from - 1, true)));
    double[] result = new double[size];
    for (int i = 0; i < size; i++) {
      result[i] = i < from ? UNKNOWN : Math.min(kept[i], there[i - from]);
    }
    return result;
  }

  /**
   * Returns whether it is true and was false one sample before; nothing precedes the first sample.
   */
  static double[] rise(double[] values) {
    double[] result = new double[values.length];
    for (int i = 0; i < values.length; i++) {
      result[i] = i == 0 ? Double.NEGATIVE_INFINITY : Math.min(values[i], -values[i - 1]);
    }
    return result;
  }
}
