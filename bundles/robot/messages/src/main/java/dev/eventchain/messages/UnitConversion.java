package dev.eventchain.messages;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Locale;
import java.util.Optional;

/**
 * Arithmetic that converts numbers of one unit to another one of the same dimension: the number is
 * multiplied or divided, then a shift is added. Factors are those that people would write, 3.6 and
 * not 0.2777777777777778, where such a number is exact to the last digits of a double.
 */
public final class UnitConversion {

  /** The unit roundoff of a double is 1.1e-16; a factor is a quotient of two of them. */
  private static final double EXACT = 1e-15;

  private static final MathContext SHORT = new MathContext(12);

  private final boolean divides;
  private final double factor;
  private final double shift;

  private UnitConversion(boolean divides, double factor, double shift) {
    this.divides = divides;
    this.factor = factor;
    this.shift = shift;
  }

  /**
   * Returns the conversion from a unit to another one.
   *
   * @return empty if one of them is unknown, or their dimensions differ
   */
  public static Optional<UnitConversion> between(String from, String to) {
    Optional<Unit> source = Unit.parse(from);
    Optional<Unit> target = Unit.parse(to);
    return source.isEmpty() || target.isEmpty()
        ? Optional.empty()
        : between(source.get(), target.get());
  }

  private static Optional<UnitConversion> between(Unit from, Unit to) {
    return switch (from.relationTo(to)) {
      case SAME -> Optional.of(new UnitConversion(false, 1.0, 0.0));
      case CONVERTIBLE -> Optional.of(of(from.factorTo(to), rounded(from.shiftTo(to))));
      case ANGLE, INCOMPATIBLE -> Optional.empty();
    };
  }

  private static UnitConversion of(double factor, double shift) {
    double divisor = rounded(1.0 / factor);
    double multiplier = rounded(factor);
    boolean multiplies = Math.abs(multiplier / factor - 1.0) < EXACT;
    boolean divides = Math.abs(divisor * factor - 1.0) < EXACT;
    if (divides && (factor < 1.0 || !multiplies)) {
      return new UnitConversion(true, divisor, shift);
    }
    return new UnitConversion(false, multiplies ? multiplier : factor, shift);
  }

  private static double rounded(double value) {
    return new BigDecimal(value).round(SHORT).doubleValue();
  }

  /** Returns a converted number. */
  public double apply(double number) {
    return (divides ? number / factor : number * factor) + shift;
  }

  /**
   * Returns the operators that convert an operand to their left, as most programming languages
   * write them: {@code "/ 3.6"}, {@code "* 1.8 + 32.0"}; {@code "* 1.0"} for equal units with
   * different spellings. The result has floating point also where the operand is an integer.
   */
  public String operators() {
    String shifted = shift == 0.0 ? "" : (shift < 0 ? "- " : "+ ") + literal(Math.abs(shift));
    if (factor == 1.0 && !shifted.isEmpty()) {
      return shifted;
    }
    String scaled = (divides ? "/ " : "* ") + literal(factor);
    return (scaled + " " + shifted).strip();
  }

  private static String literal(double number) {
    return Double.toString(number).toLowerCase(Locale.ROOT);
  }
}
