package dev.eventchain.messages;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.regex.Pattern;

/**
 * A unit of measurement in the notation of vehicle signals: {@code m/s}, {@code km/h}, {@code
 * m/s^2}, {@code m.s-2}, {@code degC}. The symbols are those of UCUM and other common spellings.
 * Immutable.
 */
public final class Unit {

  private static final double ALMOST = 1e-9;

  /** A quotient as people say it: "kmph", "m per s". */
  private static final Pattern PER = Pattern.compile("(?<=\\p{L})(\\s+per\\s+|per|p)(?=\\p{L})");

  /** A project has few units, and a simulation asks for them with each message. */
  private static final int MOST_PARSED = 500;

  private static final List<String> COMMON =
      List.of("m", "km", "cm", "s", "ms", "m/s", "km/h", "m/s2", "deg", "rad", "%", "1");

  private static final Map<String, Optional<Unit>> PARSED = new ConcurrentHashMap<>();

  private final int[] exponents;
  private final double scale;
  private final double offset;

  /**
   * Creates a unit.
   *
   * @param exponents exponents of the base dimensions, see {@link UnitTable}
   * @param scale size in the coherent unit of the same dimension: 0.01 for cm
   * @param offset offset added after scaling; 0 except for temperatures
   */
  Unit(int[] exponents, double scale, double offset) {
    this.exponents = exponents.clone();
    this.scale = scale;
    this.offset = offset;
  }

  /** Relations between two units. */
  public enum Relation {
    /** Equal units: numbers are interchangeable. */
    SAME,
    /** Same dimension with different scale or offset: km/h and m/s. */
    CONVERTIBLE,
    /** Same dimension except for angles: rad and 1, rad/s and Hz. The meaning is ambiguous. */
    ANGLE,
    /** Different dimensions: m/s and m/s2. */
    INCOMPATIBLE
  }

  /**
   * Parses a unit.
   *
   * @return empty if the text is not a known unit
   */
  public static Optional<Unit> parse(String text) {
    Optional<Unit> parsed = PARSED.get(text);
    if (parsed == null) {
      parsed = UnitParser.parse(text);
      if (PARSED.size() < MOST_PARSED) {
        PARSED.put(text, parsed);
      }
    }
    return parsed;
  }

  /** Returns the units that people write most about vehicles. */
  public static List<String> common() {
    return COMMON;
  }

  /**
   * Returns all symbols of units, without prefixes: {@code Pa}, of which {@code kPa} is one, too.
   */
  public static List<String> symbols() {
    return UnitTable.symbols();
  }

  /**
   * Returns an unknown unit in the spelling that is known, such as {@code km/h} for {@code kmph};
   * empty if the unit is known, or is none in any spelling.
   */
  public static Optional<String> respelled(String text) {
    String divided = PER.matcher(text.strip()).replaceAll("/");
    return parse(text).isPresent()
        ? Optional.empty()
        : Optional.of(divided).filter(it -> parse(it).isPresent());
  }

  /** Returns the relation of this unit to another one. */
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
   * Describes the conversion from this unit to a {@link Relation#CONVERTIBLE} one: "multiply by
   * 3.6", "subtract 273.15".
   */
  public String conversionTo(Unit other) {
    double factor = factorTo(other);
    double shift = shiftTo(other);
    boolean scaled = Math.abs(factor - 1.0) >= ALMOST;
    String multiplied =
        factor >= 1.0 ? "multiply by " + number(factor) : "divide by " + number(1 / factor);
    String shifted = (shift < 0 ? "subtract " : "add ") + number(Math.abs(shift));
    if (Math.abs(shift) < ALMOST) {
      return multiplied;
    }
    return scaled ? multiplied + ", then " + shifted : shifted;
  }

  /** Returns by what a number of this unit is multiplied to get to another one. */
  double factorTo(Unit other) {
    return scale / other.scale;
  }

  /** Returns what is then added; 0 except between temperatures. */
  double shiftTo(Unit other) {
    return (offset - other.offset) / other.scale;
  }

  /** Returns a number with at most ten digits, without artefacts of rounding. */
  private static String number(double value) {
    return new BigDecimal(value).round(new MathContext(10)).stripTrailingZeros().toPlainString();
  }

  boolean isFinite() {
    return Double.isFinite(scale) && scale > 0.0;
  }

  /**
   * Converts a number of this unit to the coherent unit of the same dimension, such as m/s for
   * km/h.
   *
   * @return the nearest double for decimal scales such as cm: 29 % is 0.29, which 29 times 0.01 is
   *     not always
   */
  public double coherent(double number) {
    double parts = 1.0 / scale;
    boolean divides = scale < 1.0 && parts == Math.rint(parts);
    return (divides ? number / parts : number * scale) + offset;
  }

  /**
   * Converts a number of the coherent unit to this one: the inverse of {@link #coherent}.
   *
   * @return the nearest double for decimal scales such as cm
   */
  public double ofCoherent(double number) {
    double parts = 1.0 / scale;
    boolean multiplies = scale < 1.0 && parts == Math.rint(parts);
    double shifted = number - offset;
    return multiplies ? shifted * parts : shifted / scale;
  }

  /** Returns the product with a power of another unit; -1 gives the quotient. */
  public Unit times(Unit other, int power) {
    int[] sum = exponents.clone();
    for (int i = 0; i < sum.length; i++) {
      sum[i] += power * other.exponents[i];
    }
    // A difference of temperatures has no offset: K/s and degC/s are the same.
    return new Unit(sum, scale * Math.pow(other.scale, power), 0.0);
  }
}
