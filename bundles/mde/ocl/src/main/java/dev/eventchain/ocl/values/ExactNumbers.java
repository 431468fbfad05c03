package dev.eventchain.ocl.values;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.math.MathContext;
import java.math.RoundingMode;
import org.eclipse.ocl.utilities.PredefinedType;

/**
 * Arithmetic with numbers of any Java type in {@link Numbers}. Integers are exact at any size.
 * Reals are computed as doubles, but those of a BigDecimal are exact where possible.
 */
public final class ExactNumbers {

  private static final BigDecimal HALF = new BigDecimal("0.5");
  private static final MathContext PRECISE = MathContext.DECIMAL128;

  private ExactNumbers() {}

  /** Returns the result, which may be invalid. */
  public static Object binary(int code, Object first, Object second) {
    if (code == PredefinedType.MAX || code == PredefinedType.MIN) {
      return extreme(code == PredefinedType.MAX, first, second);
    } else if (Numbers.isInteger(first) && Numbers.isInteger(second)) {
      return integers(code, first, second);
    } else if (Numbers.isFinite(first)
        && Numbers.isFinite(second)
        && (first instanceof BigDecimal || second instanceof BigDecimal)) {
      return decimals(code, Numbers.decimal(first), Numbers.decimal(second));
    }
    return reals(code, ((Number) first).doubleValue(), ((Number) second).doubleValue());
  }

  private static Object integers(int code, Object first, Object second) {
    boolean byZero = Numbers.areLong(second, second) && ((Number) second).longValue() == 0;
    if (code == PredefinedType.DIVIDE) {
      return byZero ? Values.INVALID : quotient(first, second);
    } else if (byZero && (code == PredefinedType.DIV || code == PredefinedType.MOD)) {
      return Values.INVALID;
    }
    if (Numbers.areLong(first, second)) {
      Object result = longs(code, ((Number) first).longValue(), ((Number) second).longValue());
      if (result != null) {
        return result;
      }
    }
    return bigs(code, Numbers.big(first), Numbers.big(second));
  }

  private static Object quotient(Object first, Object second) {
    return Numbers.isSmall(first) && Numbers.isSmall(second)
        ? ((Number) first).doubleValue() / ((Number) second).doubleValue()
        : Numbers.decimal(first).divide(Numbers.decimal(second), PRECISE).doubleValue();
  }

  /** Returns the result; null if a long cannot hold it. */
  private static Object longs(int code, long first, long second) {
    try {
      return switch (code) {
        case PredefinedType.PLUS -> Numbers.integer(Math.addExact(first, second));
        case PredefinedType.MINUS -> Numbers.integer(Math.subtractExact(first, second));
        case PredefinedType.TIMES -> Numbers.integer(Math.multiplyExact(first, second));
        case PredefinedType.MOD -> Numbers.integer(first % second);
        default -> first == Long.MIN_VALUE && second == -1 ? null : Numbers.integer(first / second);
      };
    } catch (ArithmeticException e) {
      return null;
    }
  }

  private static Object bigs(int code, BigInteger first, BigInteger second) {
    return Numbers.integer(
        switch (code) {
          case PredefinedType.PLUS -> first.add(second);
          case PredefinedType.MINUS -> first.subtract(second);
          case PredefinedType.TIMES -> first.multiply(second);
          case PredefinedType.MOD -> first.remainder(second);
          default -> first.divide(second);
        });
  }

  private static Object decimals(int code, BigDecimal first, BigDecimal second) {
    if (code == PredefinedType.DIVIDE) {
      return second.signum() == 0
          ? Values.INVALID
          : (Object) first.divide(second, PRECISE).doubleValue();
    } else if (!Numbers.isModest(first) || !Numbers.isModest(second)) {
      return reals(code, first.doubleValue(), second.doubleValue());
    }
    return switch (code) {
      case PredefinedType.PLUS -> Numbers.real(first.add(second));
      case PredefinedType.MINUS -> Numbers.real(first.subtract(second));
      case PredefinedType.TIMES -> Numbers.real(first.multiply(second));
      default -> Values.INVALID; // div and mod of reals
    };
  }

  private static Object reals(int code, double first, double second) {
    return switch (code) {
      case PredefinedType.PLUS -> first + second;
      case PredefinedType.MINUS -> first - second;
      case PredefinedType.TIMES -> first * second;
      case PredefinedType.DIVIDE -> second == 0.0 ? Values.INVALID : (Object) (first / second);
      default -> Values.INVALID; // div and mod of reals
    };
  }

  /** Returns the larger or smaller number; of Integer and Real as a Real, if that can hold it. */
  private static Object extreme(boolean larger, Object first, Object second) {
    boolean takesFirst = Numbers.compare(first, second) > 0 == larger;
    Object result = takesFirst ? first : second;
    boolean mixed = Numbers.isInteger(first) != Numbers.isInteger(second);
    if (!Numbers.isFinite(first) || !Numbers.isFinite(second)) {
      double one = ((Number) first).doubleValue();
      double other = ((Number) second).doubleValue();
      return larger ? Math.max(one, other) : Math.min(one, other);
    }
    return mixed && Numbers.isSmall(result) ? (Object) ((Number) result).doubleValue() : result;
  }

  /** Computes minus, {@code abs}, {@code floor} or {@code round}. */
  public static Object unary(int code, Object value) {
    boolean whole = Numbers.isInteger(value);
    return switch (code) {
      case PredefinedType.MINUS -> negated(value);
      case PredefinedType.ABS -> isNegative(value) ? negated(value) : value;
      default -> whole ? value : rounded(value, code == PredefinedType.ROUND);
    };
  }

  /** Returns whether a number is negative, which also applies to -0.0. */
  private static boolean isNegative(Object value) {
    return value instanceof Double number
        ? number < 0 || Double.compare(number, -0.0) == 0
        : Numbers.decimal(value).signum() < 0;
  }

  private static Object negated(Object value) {
    if (value instanceof Integer number) {
      return Numbers.integer(-(long) number);
    } else if (value instanceof Double number) {
      return -number;
    } else if (value instanceof BigDecimal number) {
      return number.negate();
    }
    return Numbers.integer(Numbers.big(value).negate());
  }

  /** Rounds a number; of two equally close Integers, to the larger one. */
  private static Object rounded(Object value, boolean nearest) {
    if (!Numbers.isFinite(value)) {
      return Values.INVALID;
    }
    if (value instanceof Double real && Math.abs(real) < Integer.MAX_VALUE) {
      return Numbers.integer(nearest ? Math.round(real) : (long) Math.floor(real));
    }
    BigDecimal number = Numbers.decimal(value);
    if ((long) number.precision() - number.scale() > Limits.MOST_BITS) {
      Limits.requireBits(Long.MAX_VALUE);
    }
    if (number.scale() - (long) number.precision() > 1) {
      return nearest || number.signum() >= 0 ? 0 : -1; // smaller than a tenth
    }
    BigDecimal upTo = nearest ? number.add(HALF) : number;
    return Numbers.integer(upTo.setScale(0, RoundingMode.FLOOR).toBigInteger());
  }
}
