package dev.eventchain.workspace.launch;

import java.math.BigDecimal;
import java.util.List;
import java.util.Locale;
import java.util.function.BiFunction;

/**
 * Values of Python in expressions of launch files: texts, numbers, Booleans, lists; and what its
 * operators and functions make of them.
 */
final class LaunchValues {

  /** End of an expression whose value is not known. */
  static final class UnknownException extends RuntimeException {
    private static final long serialVersionUID = 1;

    UnknownException() {
      super(null, null, false, false);
    }
  }

  private LaunchValues() {}

  static String written(Object value) {
    if (value instanceof Boolean truth) {
      return truth ? "True" : "False";
    } else if (value instanceof Double number) {
      return written(number.doubleValue());
    } else if (value instanceof List) {
      throw new UnknownException();
    }
    return String.valueOf(value);
  }

  /** Returns the shortest digits that give a number again, where Python writes no exponent. */
  private static String written(double number) {
    double size = Math.abs(number);
    if (!(size == 0 || (size >= 1e-4 && size < 1e16))) {
      throw new UnknownException();
    }
    for (int digits = 1; digits <= 17; digits++) {
      String text = String.format(Locale.ROOT, "%." + (digits - 1) + "e", number);
      if (Double.parseDouble(text) == number) {
        String plain = new BigDecimal(text).toPlainString();
        String sign = number == 0 && 1 / number < 0 && !plain.startsWith("-") ? "-" : "";
        return sign + (plain.contains(".") ? plain : plain + ".0");
      }
    }
    throw new UnknownException();
  }

  static boolean compare(String operator, Object left, Object right) {
    return switch (operator) {
      case "==" -> equal(left, right);
      case "!=" -> !equal(left, right);
      case "in" -> isIn(left, right);
      case "not in" -> !isIn(left, right);
      case "<" -> order(left, right) < 0;
      case "<=" -> order(left, right) <= 0;
      case ">" -> order(left, right) > 0;
      default -> order(left, right) >= 0;
    };
  }

  private static boolean equal(Object left, Object right) {
    if (left instanceof List || right instanceof List) {
      throw new UnknownException();
    }
    boolean numbers = !(left instanceof String) && !(right instanceof String);
    return numbers ? number(left).compareTo(number(right)) == 0 : left.equals(right);
  }

  private static boolean isIn(Object part, Object whole) {
    if (whole instanceof String text && part instanceof String inner) {
      return text.contains(inner);
    } else if (whole instanceof List<?> list) {
      return list.stream().anyMatch(each -> equal(part, each));
    }
    throw new UnknownException();
  }

  private static int order(Object left, Object right) {
    if (left instanceof String one && right instanceof String other) {
      return one.compareTo(other);
    }
    return number(left).compareTo(number(right));
  }

  static boolean truth(Object value) {
    if (value instanceof String text) {
      return !text.isEmpty();
    } else if (value instanceof List<?> list) {
      return !list.isEmpty();
    }
    return number(value).signum() != 0;
  }

  static BigDecimal number(Object value) {
    if (value instanceof Boolean truth) {
      return truth ? BigDecimal.ONE : BigDecimal.ZERO;
    } else if (value instanceof Long whole) {
      return BigDecimal.valueOf(whole);
    } else if (value instanceof Double real) {
      return new BigDecimal(real);
    }
    throw new UnknownException();
  }

  static Object calculated(
      Object left,
      Object right,
      BiFunction<Long, Long, Long> whole,
      BiFunction<Double, Double, Double> real) {
    BigDecimal one = number(left);
    BigDecimal other = number(right);
    if (left instanceof Double || right instanceof Double) {
      return finite(real.apply(one.doubleValue(), other.doubleValue()));
    }
    try {
      return whole.apply(one.longValueExact(), other.longValueExact());
    } catch (ArithmeticException e) {
      throw new UnknownException();
    }
  }

  static double finite(double value) {
    if (!Double.isFinite(value)) {
      throw new UnknownException();
    }
    return value;
  }

  static Object called(String text, String method, List<Object> given) {
    if (given.isEmpty()) {
      return switch (method) {
        case "lower" -> text.toLowerCase(Locale.ROOT);
        case "upper" -> text.toUpperCase(Locale.ROOT);
        case "strip" -> text.strip();
        default -> throw new UnknownException();
      };
    } else if (given.size() == 1 && given.get(0) instanceof String part) {
      return switch (method) {
        case "startswith" -> text.startsWith(part);
        case "endswith" -> text.endsWith(part);
        default -> throw new UnknownException();
      };
    }
    throw new UnknownException();
  }

  /** Returns what a function of Python makes of a value. */
  static Object converted(String function, Object value) {
    if (function.equals("str")) {
      return written(value);
    } else if (function.equals("bool")) {
      return truth(value);
    } else if (value instanceof String text) {
      String plain = text.strip();
      if (function.equals("int") && plain.matches("[-+]?[0-9]{1,18}")) {
        return Long.valueOf(plain);
      } else if (function.equals("float") && plain.matches("[-+]?[0-9]+(\\.[0-9]*)?")) {
        return finite(Double.parseDouble(plain));
      }
      throw new UnknownException();
    }
    double number = number(value).doubleValue();
    return function.equals("float") ? (Object) finite(number) : (Object) (long) number;
  }
}
