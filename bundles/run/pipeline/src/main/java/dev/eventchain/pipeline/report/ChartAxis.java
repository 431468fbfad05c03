package dev.eventchain.pipeline.report;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;

/**
 * An axis of a chart, divided by round numbers.
 *
 * @param first the smallest of them, not above any value
 * @param step from one to the next: 1, 2 or 5 times a power of ten
 * @param count how many steps, at least one
 */
record ChartAxis(BigDecimal first, BigDecimal step, int count) {

  private static final List<BigDecimal> ROUND =
      List.of(BigDecimal.ONE, BigDecimal.valueOf(2), BigDecimal.valueOf(5), BigDecimal.TEN);

  /**
   * Returns an axis for values.
   *
   * @param steps about how many
   */
  static ChartAxis of(double least, double most, int steps) {
    double rough = most > least ? (most - least) / steps : Math.max(Math.abs(least), 1) / steps;
    BigDecimal power = BigDecimal.ONE.scaleByPowerOfTen((int) Math.floor(Math.log10(rough)));
    BigDecimal step =
        ROUND.stream()
            .map(power::multiply)
            .filter(each -> each.doubleValue() >= rough)
            .findFirst()
            .orElse(power.multiply(BigDecimal.TEN));
    long from = (long) Math.floor(least / step.doubleValue());
    long to = Math.max(from + 1, (long) Math.ceil(most / step.doubleValue()));
    return new ChartAxis(step.multiply(BigDecimal.valueOf(from)), step, Math.toIntExact(to - from));
  }

  /** Returns the round numbers, from the smallest one on. */
  List<BigDecimal> ticks() {
    List<BigDecimal> ticks = new ArrayList<>();
    for (int i = 0; i <= count; i++) {
      ticks.add(first.add(step.multiply(BigDecimal.valueOf(i))));
    }
    return ticks;
  }

  /** Returns where a value lies: 0 at the first of the numbers, 1 at the last. */
  double share(double value) {
    return (value - first.doubleValue()) / step.doubleValue() / count;
  }

  /** Returns the step in which a value lies, from 0; the last number belongs to the last step. */
  int bin(double value) {
    int bin = Math.max(0, Math.min(count - 1, (int) Math.floor(share(value) * count)));
    // A share is not exact, and a value on one of the numbers belongs to the step after it.
    return bin < count - 1 && value >= start(bin + 1) ? bin + 1 : bin;
  }

  private double start(int bin) {
    return first.add(step.multiply(BigDecimal.valueOf(bin))).doubleValue();
  }

  static String text(BigDecimal value) {
    return value.signum() == 0
        ? "0"
        : value.round(new MathContext(6)).stripTrailingZeros().toPlainString();
  }
}
