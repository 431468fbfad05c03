package dev.eventchain.simulation.coverage;

import dev.eventchain.simulation.coverage.SignalCoverage.Kind;
import java.math.BigDecimal;
import java.math.MathContext;

/** Measured numbers in words. */
final class Figures {

  private static final MathContext DIGITS = new MathContext(3);

  private Figures() {}

  /** Returns a finite number with three digits. */
  static String of(double value) {
    BigDecimal rounded = new BigDecimal(value).round(DIGITS);
    return rounded.signum() == 0 ? "0" : rounded.stripTrailingZeros().toPlainString();
  }

  /** Returns a finite number with three digits, and its unit. */
  static String of(double value, String unit) {
    return of(value) + (unit.isEmpty() || unit.equals("1") ? "" : " " + unit);
  }

  /** Returns the range of a number. */
  static String range(SignalCoverage signal) {
    String most = of(signal.most(), signal.kind() == Kind.LIST ? "" : signal.unit());
    return signal.least() == signal.most() ? most : of(signal.least()) + " to " + most;
  }
}
