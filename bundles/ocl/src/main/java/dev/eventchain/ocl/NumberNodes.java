package dev.eventchain.ocl;

import org.eclipse.ocl.utilities.PredefinedType;

/**
 * Arithmetic and comparison. Integers are computed as long and doubles as double, as Eclipse OCL
 * does; what is neither goes to its evaluator.
 */
final class NumberNodes {

  private NumberNodes() {}

  /** The number as OCL holds it: an Integer if it fits. */
  private static Object integer(long value) {
    int small = (int) value;
    return small == value ? (Object) small : (Object) value;
  }

  private static boolean isInteger(Object value) {
    return value instanceof Integer || value instanceof Long;
  }

  /** An operation with two operands. */
  private abstract static class Operation extends LogicNodes.Binary {
    private final StockOperation stock;

    Operation(Node left, Node right, StockOperation stock) {
      super(left, right);
      this.stock = stock;
    }

    @Override
    final Object evaluate(Frame frame) {
      Object first = left.evaluate(frame);
      if (isUndefined(first)) {
        return INVALID;
      }
      Object second = right.evaluate(frame);
      if (second == INVALID) {
        return INVALID;
      } else if (first instanceof Integer one && second instanceof Integer other) {
        return integers(one, other);
      } else if (first instanceof Double one && second instanceof Double other) {
        return reals(one, other);
      } else if (isInteger(first) && isInteger(second)) {
        return integers(((Number) first).longValue(), ((Number) second).longValue());
      } else if (isNumber(first) && isNumber(second)) {
        return reals(((Number) first).doubleValue(), ((Number) second).doubleValue());
      }
      return other(frame, first, second);
    }

    private static boolean isNumber(Object value) {
      return value instanceof Double || isInteger(value);
    }

    abstract Object integers(long first, long second);

    abstract Object reals(double first, double second);

    Object other(Frame frame, Object first, Object second) {
      return stock.apply(frame, first, second);
    }
  }

  /** Arithmetic with two operands. */
  static final class Arithmetic extends Operation {
    private final int code;

    Arithmetic(int code, Node left, Node right, StockOperation stock) {
      super(left, right, stock);
      this.code = code;
    }

    static boolean has(int code) {
      return switch (code) {
        case PredefinedType.PLUS,
            PredefinedType.MINUS,
            PredefinedType.TIMES,
            PredefinedType.DIVIDE,
            PredefinedType.DIV,
            PredefinedType.MOD,
            PredefinedType.MAX,
            PredefinedType.MIN ->
            true;
        default -> false;
      };
    }

    @Override
    Object integers(long first, long second) {
      return switch (code) {
        case PredefinedType.PLUS -> integer(first + second);
        case PredefinedType.MINUS -> integer(first - second);
        case PredefinedType.TIMES -> integer(first * second);
        case PredefinedType.DIVIDE -> second == 0 ? INVALID : (Object) ((double) first / second);
        case PredefinedType.DIV -> second == 0 ? INVALID : integer(first / second);
        case PredefinedType.MOD -> second == 0 ? INVALID : integer(first % second);
        case PredefinedType.MAX -> integer(Math.max(first, second));
        default -> integer(Math.min(first, second));
      };
    }

    @Override
    Object reals(double first, double second) {
      return switch (code) {
        case PredefinedType.PLUS -> first + second;
        case PredefinedType.MINUS -> first - second;
        case PredefinedType.TIMES -> first * second;
        case PredefinedType.DIVIDE -> second == 0.0 ? INVALID : (Object) (first / second);
        case PredefinedType.MAX -> Math.max(first, second);
        case PredefinedType.MIN -> Math.min(first, second);
        default -> INVALID; // div and mod of reals
      };
    }
  }

  /** A comparison. */
  abstract static class Comparison extends Operation {

    private Comparison(Node left, Node right, StockOperation stock) {
      super(left, right, stock);
    }

    static Comparison of(int code, Node left, Node right, StockOperation stock) {
      return switch (code) {
        case PredefinedType.LESS_THAN -> new Less(left, right, stock);
        case PredefinedType.LESS_THAN_EQUAL -> new LessOrEqual(left, right, stock);
        case PredefinedType.GREATER_THAN -> new Greater(left, right, stock);
        default -> new GreaterOrEqual(left, right, stock);
      };
    }

    static boolean has(int code) {
      return code >= PredefinedType.LESS_THAN && code <= PredefinedType.GREATER_THAN_EQUAL;
    }

    @Override
    final Object other(Frame frame, Object first, Object second) {
      return first instanceof String one && second instanceof String other
          ? integers(one.compareTo(other), 0)
          : super.other(frame, first, second);
    }
  }

  private static final class Less extends Comparison {
    Less(Node left, Node right, StockOperation stock) {
      super(left, right, stock);
    }

    @Override
    Object integers(long first, long second) {
      return first < second;
    }

    @Override
    Object reals(double first, double second) {
      return first < second;
    }
  }

  private static final class LessOrEqual extends Comparison {
    LessOrEqual(Node left, Node right, StockOperation stock) {
      super(left, right, stock);
    }

    @Override
    Object integers(long first, long second) {
      return first <= second;
    }

    @Override
    Object reals(double first, double second) {
      return first <= second;
    }
  }

  private static final class Greater extends Comparison {
    Greater(Node left, Node right, StockOperation stock) {
      super(left, right, stock);
    }

    @Override
    Object integers(long first, long second) {
      return first > second;
    }

    @Override
    Object reals(double first, double second) {
      return first > second;
    }
  }

  private static final class GreaterOrEqual extends Comparison {
    GreaterOrEqual(Node left, Node right, StockOperation stock) {
      super(left, right, stock);
    }

    @Override
    Object integers(long first, long second) {
      return first >= second;
    }

    @Override
    Object reals(double first, double second) {
      return first >= second;
    }
  }

  /** Minus, {@code abs}, {@code floor} and {@code round}. */
  static final class Unary extends Node {
    private final int code;
    private final Node operand;

    Unary(int code, Node operand) {
      this.code = code;
      this.operand = operand;
    }

    static boolean has(int code) {
      return code == PredefinedType.MINUS
          || code == PredefinedType.ABS
          || code == PredefinedType.FLOOR
          || code == PredefinedType.ROUND;
    }

    @Override
    Object evaluate(Frame frame) {
      Object value = operand.evaluate(frame);
      if (value instanceof Double real) {
        return ofReal(real);
      } else if (isUndefined(value)) {
        return INVALID;
      } else if (code == PredefinedType.FLOOR || code == PredefinedType.ROUND) {
        return value; // also of Java's other numbers with a fraction, as in Eclipse OCL
      }
      return isInteger(value) ? ofInteger((Number) value) : INVALID;
    }

    private Object ofReal(double value) {
      return switch (code) {
        case PredefinedType.MINUS -> (Object) (-value);
        case PredefinedType.ABS -> (Object) Math.abs(value);
        case PredefinedType.FLOOR -> (Object) (int) Math.floor(value);
        default -> (Object) (int) Math.round(value);
      };
    }

    /** Eclipse OCL makes an Integer of a Long only where the sign brings it back into range. */
    private Object ofInteger(Number value) {
      long number = value.longValue();
      if (code == PredefinedType.ABS) {
        return value instanceof Integer ? integer(Math.abs(number)) : (Object) Math.abs(number);
      }
      boolean small = value instanceof Integer || number == -(long) Integer.MIN_VALUE;
      return small ? integer(-number) : (Object) (-number);
    }
  }
}
