package dev.eventchain.ocl.values;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.util.regex.Pattern;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EEnum;

/**
 * The representation of OCL's numbers. An Integer of OCL is an Integer of Java if it fits, else a
 * Long, else a BigInteger; a Real is a Double, or a BigDecimal of a model. Numbers of Java's other
 * types become one of these where they enter an expression.
 *
 * <p>A Double with a fraction stands for its decimal notation, so that 0.1 as a literal, a float
 * and a BigDecimal are equal; one without is exact.
 */
public final class Numbers {

  private static final Pattern REAL =
      Pattern.compile("\\s*[+-]?[0-9]+(\\.[0-9]*)?([eE][+-]?[0-9]+)?\\s*");

  /** The limit up to which every integer is a double. */
  private static final long EXACT = 1L << 53;

  /** The limit of digits on either side of the point up to which numbers are expanded. */
  private static final int MOST_DIGITS = 1000;

  private Numbers() {}

  /** Returns the value in OCL's representation. */
  public static Object normal(Object value) {
    if (value instanceof Integer || value instanceof Double) {
      return value;
    } else if (value instanceof Long number) {
      return integer(number);
    } else if (value instanceof Float number) {
      return real(number);
    } else if (value instanceof BigInteger number) {
      return integer(number);
    } else if (value instanceof Short number) {
      return number.intValue();
    }
    return value instanceof Byte number ? (Object) number.intValue() : value;
  }

  /** Returns whether the values of a type may be numbers that {@link #normal} changes. */
  public static boolean isForeign(EClassifier type) {
    if (type instanceof EClass || type instanceof EEnum) {
      return false;
    }
    Class<?> java = type == null ? null : type.getInstanceClass();
    return java != int.class
        && java != Integer.class
        && java != boolean.class
        && java != Boolean.class
        && java != String.class
        && !isDouble(type);
  }

  /** Returns whether the values of a type are doubles. */
  public static boolean isDouble(EClassifier type) {
    Class<?> java = type == null ? null : type.getInstanceClass();
    return java == double.class || java == Double.class;
  }

  public static Object integer(long value) {
    int small = (int) value;
    return small == value ? (Object) small : (Object) value;
  }

  public static Object integer(BigInteger value) {
    Limits.requireBits(value.bitLength());
    return value.bitLength() < Long.SIZE ? integer(value.longValue()) : value;
  }

  /** Parses an Integer. */
  public static Object integer(String text) {
    try {
      return Integer.valueOf(text);
    } catch (NumberFormatException e) {
      if (text.matches("[+-]?[0-9]{10," + MOST_DIGITS + "}")) {
        return integer(new BigInteger(text));
      }
      throw e;
    }
  }

  /**
   * Parses a Real in OCL's notation.
   *
   * @throws NumberFormatException if the text is none; {@code NaN}, {@code 0x1p3} and {@code 1d}
   *     are numbers of Java only
   */
  public static Double real(String text) {
    if (!REAL.matcher(text).matches()) {
      throw new NumberFormatException("'" + text + "' is not a Real");
    }
    return Double.valueOf(text);
  }

  /** Returns the double with the same notation as a float. */
  private static Double real(float value) {
    return value == Math.rint(value) || Float.isNaN(value)
        ? Double.valueOf(value)
        : Double.valueOf(Float.toString(value));
  }

  /** Returns a Double if that is the same number. */
  static Object real(BigDecimal value) {
    double near = value.doubleValue();
    return isFinite(near) && decimal(near).compareTo(value) == 0 ? (Object) near : value;
  }

  public static boolean isInteger(Object value) {
    return value instanceof Integer || value instanceof Long || value instanceof BigInteger;
  }

  public static boolean isNumber(Object value) {
    return value instanceof Double || isInteger(value) || value instanceof BigDecimal;
  }

  public static boolean isFinite(Object value) {
    return !(value instanceof Double number) || !(number.isNaN() || number.isInfinite());
  }

  /** Returns whether both are Integers that fit a long. */
  static boolean areLong(Object first, Object second) {
    return (first instanceof Integer || first instanceof Long)
        && (second instanceof Integer || second instanceof Long);
  }

  /** Returns whether a double can hold this Integer. */
  static boolean isSmall(Object value) {
    return value instanceof Integer
        || (value instanceof Long number && -EXACT <= number && number <= EXACT);
  }

  /** Returns the number as a decimal, if it is finite. */
  static BigDecimal decimal(Object value) {
    if (value instanceof Double number) {
      return number == Math.rint(number) ? new BigDecimal(number) : BigDecimal.valueOf(number);
    } else if (value instanceof BigDecimal number) {
      return number;
    } else if (value instanceof BigInteger number) {
      return new BigDecimal(number);
    }
    return BigDecimal.valueOf(((Number) value).longValue());
  }

  static BigInteger big(Object value) {
    return value instanceof BigInteger number
        ? number
        : BigInteger.valueOf(((Number) value).longValue());
  }

  /** Returns whether a decimal has so few digits that it can be expanded. */
  static boolean isModest(BigDecimal value) {
    return value.precision() <= MOST_DIGITS && Math.abs((long) value.scale()) <= MOST_DIGITS;
  }

  /** Compares numbers; NaN is larger than all others. */
  public static int compare(Object first, Object second) {
    if (areLong(first, second)) {
      return Long.compare(((Number) first).longValue(), ((Number) second).longValue());
    }
    boolean finite = isFinite(first) && isFinite(second);
    if (finite && !(isDoubleExactly(first) && isDoubleExactly(second))) {
      return decimal(first).compareTo(decimal(second));
    }
    // Adding zero removes the sign of a zero.
    return Double.compare(
        ((Number) first).doubleValue() + 0.0, ((Number) second).doubleValue() + 0.0);
  }

  private static boolean isDoubleExactly(Object value) {
    return value instanceof Double || isSmall(value);
  }

  /** Returns a key that is equal in Java exactly for equal numbers. */
  static Object key(Object number) {
    if (number instanceof Double real) {
      return key(real);
    } else if (number instanceof BigDecimal real) {
      return key(real);
    } else if (number instanceof BigInteger large && large.bitLength() > 3 * MOST_DIGITS) {
      return new BigDecimal(large).stripTrailingZeros();
    }
    return number;
  }

  private static Object key(Double real) {
    double value = real;
    if (value != Math.rint(value) || Double.isInfinite(value)) {
      return real;
    }
    return Math.abs(value) <= EXACT ? integer((long) value) : integer(decimal(real).toBigInteger());
  }

  private static Object key(BigDecimal real) {
    Object same = real(real);
    if (same instanceof Double number) {
      return key(number);
    }
    BigDecimal stripped = real.stripTrailingZeros();
    boolean whole = stripped.scale() <= 0;
    return whole && (long) stripped.precision() - stripped.scale() <= MOST_DIGITS
        ? key(integer(stripped.toBigInteger()))
        : stripped;
  }
}
