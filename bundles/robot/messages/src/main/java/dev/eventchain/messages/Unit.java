package dev.eventchain.messages;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Arrays;
import java.util.Optional;

/**
 * A unit of measurement, as vehicle signals are written: {@code m/s}, {@code km/h}, {@code m/s^2},
 * {@code m.s-2}, {@code degC}. The symbols are those of UCUM where it has them, together with other
 * common spellings. Immutable.
 */
public final class Unit {

  private static final double ALMOST = 1e-9;

  private final int[] exponents;
  private final double scale;
  private final double offset;

  /**
   * A unit.
   *
   * @param exponents those of the base dimensions, see {@link UnitTable}
   * @param scale how many of the coherent unit of the same dimension this one is: 0.01 for cm
   * @param offset what is added after scaling; other than 0 for temperatures only
   */
  Unit(int[] exponents, double scale, double offset) {
    this.exponents = exponents.clone();
    this.scale = scale;
    this.offset = offset;
  }

  /** How the numbers of two units go together. */
  public enum Relation {
    /** The same number means the same. */
    SAME,
    /** The same dimension, other numbers: km/h and m/s. */
    CONVERTIBLE,
    /**
     * Apart from angles the same dimension: rad and 1, rad/s and Hz. What is meant cannot be told.
     */
    ANGLE,
    /** Other dimensions: m/s and m/s2. */
    INCOMPATIBLE
  }

  /**
   * Reads a unit.
   *
   * @return empty if it is not understood
   */
  public static Optional<Unit> parse(String text) {
    return UnitParser.parse(text);
  }

  /** How numbers of this unit go together with those of another. */
  public Relation relationTo(Unit other) {
    if (Arrays.equals(exponents, other.exponents)) {
      boolean same = Math.abs(scale / other.scale - 1.0) < ALMOST && offset == other.offset;
      return same ? Relation.SAME : Relation.CONVERTIBLE;
    }
    int[] turned = exponents.clone();
    turned[UnitTable.ANGLE] = other.exponents[UnitTable.ANGLE];
    return Arrays.equals(turned, other.exponents) ? Relation.ANGLE : Relation.INCOMPATIBLE;
  }

  /**
   * How a number of this unit becomes one of a {@link Relation#CONVERTIBLE} other: "multiply by
   * 3.6", "subtract 273.15".
   */
  public String conversionTo(Unit other) {
    double factor = scale / other.scale;
    double shift = (offset - other.offset) / other.scale;
    boolean scaled = Math.abs(factor - 1.0) >= ALMOST;
    String multiplied =
        factor >= 1.0 ? "multiply by " + number(factor) : "divide by " + number(1 / factor);
    String shifted = (shift < 0 ? "subtract " : "add ") + number(Math.abs(shift));
    if (Math.abs(shift) < ALMOST) {
      return multiplied;
    }
    return scaled ? multiplied + ", then " + shifted : shifted;
  }

  /** At most ten digits, without those that only rounding put there. */
  private static String number(double value) {
    return new BigDecimal(value).round(new MathContext(10)).stripTrailingZeros().toPlainString();
  }

  boolean isFinite() {
    return Double.isFinite(scale) && scale > 0.0;
  }

  /**
   * A number of this unit in the coherent unit of the same dimension, such as m/s for km/h.
   *
   * @return for cm and the like the nearest double: 29 % is 0.29, which 29 times 0.01 is not always
   */
  public double coherent(double number) {
    double parts = 1.0 / scale;
    boolean divides = scale < 1.0 && parts == Math.rint(parts);
    return (divides ? number / parts : number * scale) + offset;
  }

  /**
   * A number of the coherent unit in this one: the inverse of {@link #coherent}.
   *
   * @return for cm and the like the nearest double
   */
  public double ofCoherent(double number) {
    double parts = 1.0 / scale;
    boolean multiplies = scale < 1.0 && parts == Math.rint(parts);
    double shifted = number - offset;
    return multiplies ? shifted * parts : shifted / scale;
  }

  /** The unit of a product with a power of another one: with -1 that of the quotient. */
  public Unit times(Unit other, int power) {
    int[] sum = exponents.clone();
    for (int i = 0; i < sum.length; i++) {
      sum[i] += power * other.exponents[i];
    }
    // A difference of temperatures has no offset: K/s and degC/s are the same.
    return new Unit(sum, scale * Math.pow(other.scale, power), 0.0);
  }
}
