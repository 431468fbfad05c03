package dev.eventchain.pipeline.evaluation;

import java.util.Optional;

/**
 * Where the true rate of successes lies with a confidence of 95 %, by Wilson's score method, which
 * is valid for few trials and for rates near 0 and 1, too.
 */
record WilsonInterval(double low, double high) {

  /** The quantile of the normal distribution for two sides of 2.5 %. */
  private static final double Z = 1.959963984540054;

  /** The interval for {@code successes} of {@code trials}; none where nothing was tried. */
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
