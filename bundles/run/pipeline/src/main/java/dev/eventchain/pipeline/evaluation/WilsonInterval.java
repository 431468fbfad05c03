package dev.eventchain.pipeline.evaluation;

import java.util.Optional;

/**
 * The 95 % confidence interval of a success rate by Wilson's score method, which is also valid for
 * few trials and for rates near 0 and 1.
 */
record WilsonInterval(double low, double high) {

  /** The two-sided 95 % quantile of the normal distribution. */
  private static final double Z = 1.959963984540054;

  /** Returns the interval for {@code successes} of {@code trials}; empty without trials. */
  static Optional<WilsonInterval> of(int successes, int trials) {
    if (successes < 0 || successes > trials) {
      throw new IllegalArgumentException(successes + " of " + trials);
    }
    if (trials == 0) {
      return Optional.empty();
    }
    double n = trials;
    double rate = successes / n;
    double middle = (rate + Z * Z / (2 * n)) / (1 + Z * Z / n);
    double half = Z * Math.sqrt(rate * (1 - rate) / n + Z * Z / (4 * n * n)) / (1 + Z * Z / n);
    double low = successes == 0 ? 0 : middle - half;
    double high = successes == trials ? 1 : middle + half;
    return Optional.of(new WilsonInterval(low, high));
  }
}
