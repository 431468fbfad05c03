package dev.eventchain.ocl.nodes;

import dev.eventchain.ocl.values.ExactNumbers;
import dev.eventchain.ocl.values.Numbers;
import dev.eventchain.ocl.values.Unlimited;
import org.eclipse.ocl.utilities.PredefinedType;

/**
 * Arithmetic and comparison. Small Integers are computed as long and doubles as double; see {@link
 * ExactNumbers} for all others.
 */
public final class NumberNodes {

  private NumberNodes() {}

  /** Returns the result for two numbers of any Java types, which may be invalid. */
  static Object binary(int code, Object first, Object second) {
    if (first instanceof Integer one && second instanceof Integer other) {
      return Arithmetic.integers(code, one, other);
    } else if (first instanceof Double one && second instanceof Double other) {
      return Arithmetic.reals(code, one, other);
    }
    return ExactNumbers.binary(code, first, second);
  }

  /** {@code oclAsType(Real)} of an Integer, which is written as a Real from then on. */
  public static final class AsReal extends Node {
    private final Node source;

    public AsReal(Node source) {
      this.source = source;
    }

    @Override
    Object evaluate(Frame frame) {
      Object value = source.evaluate(frame);
      return value instanceof Number number ? (Object) number.doubleValue() : value;
    }
  }

  /** An operation with two operands. */
  private abstract static class Operation extends LogicNodes.Binary {

    Operation(Node left, Node right) {
      super(left, right);
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
      } else if (Numbers.isNumber(first) && Numbers.isNumber(second)) {
        return mixed(first, second);
      }
      return other(first, second);
    }

    /** Computes with 32-bit numbers, which cannot overflow a long. */
    abstract Object integers(long first, long second);

    abstract Object reals(double first, double second);

    /** Computes with numbers of any two Java types. */
    abstract Object mixed(Object first, Object second);

    Object other(Object first, Object second) {
      return INVALID;
    }
  }

  /** Arithmetic with two operands. */
  public static final class Arithmetic extends Operation {
    private final int code;

    public Arithmetic(int code, Node left, Node right) {
      super(left, right);
      this.code = code;
    }

    public static boolean has(int code) {
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
      return integers(code, first, second);
    }

    @Override
    Object reals(double first, double second) {
      return reals(code, first, second);
    }

    private static Object integers(int code, long first, long second) {
      return switch (code) {
        case PredefinedType.PLUS -> Numbers.integer(first + second);
        case PredefinedType.MINUS -> Numbers.integer(first - second);
        case PredefinedType.TIMES -> Numbers.integer(first * second);
        case PredefinedType.DIVIDE -> second == 0 ? INVALID : (Object) ((double) first / second);
        case PredefinedType.DIV -> second == 0 ? INVALID : Numbers.integer(first / second);
        case PredefinedType.MOD -> second == 0 ? INVALID : Numbers.integer(first % second);
        case PredefinedType.MAX -> Numbers.integer(Math.max(first, second));
        default -> Numbers.integer(Math.min(first, second));
      };
    }

    private static Object reals(int code, double first, double second) {
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

    @Override
    Object mixed(Object first, Object second) {
      return ExactNumbers.binary(code, first, second);
    }
  }

  /** A comparison. */
  public abstract static class Comparison extends Operation {

    private Comparison(Node left, Node right) {
      super(left, right);
    }

    public static Comparison of(int code, Node left, Node right) {
      return switch (code) {
        case PredefinedType.LESS_THAN -> new Less(left, right);
        case PredefinedType.LESS_THAN_EQUAL -> new LessOrEqual(left, right);
        case PredefinedType.GREATER_THAN -> new Greater(left, right);
        default -> new GreaterOrEqual(left, right);
      };
    }

    public static boolean has(int code) {
      return code >= PredefinedType.LESS_THAN && code <= PredefinedType.GREATER_THAN_EQUAL;
    }

    @Override
    final Object mixed(Object first, Object second) {
      if (!Numbers.isFinite(first) || !Numbers.isFinite(second)) {
        return reals(((Number) first).doubleValue(), ((Number) second).doubleValue());
      }
      return integers(Numbers.compare(first, second), 0);
    }

    @Override
    final Object other(Object first, Object second) {
      if (first == Unlimited.UNLIMITED || second == Unlimited.UNLIMITED) {
        return second == null ? INVALID : integers(rank(first), rank(second));
      }
      return first instanceof String one && second instanceof String other
          ? integers(one.compareTo(other), 0)
          : INVALID;
    }

    private static int rank(Object number) {
      return number == Unlimited.UNLIMITED ? 1 : 0;
    }
  }

  private static final class Less extends Comparison {
    Less(Node left, Node right) {
      super(left, right);
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
    LessOrEqual(Node left, Node right) {
      super(left, right);
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
    Greater(Node left, Node right) {
      super(left, right);
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
    GreaterOrEqual(Node left, Node right) {
      super(left, right);
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
  public static final class Unary extends Node {
    private final int code;
    private final Node operand;

    public Unary(int code, Node operand) {
      this.code = code;
      this.operand = operand;
    }

    public static boolean has(int code) {
      return code == PredefinedType.MINUS
          || code == PredefinedType.ABS
          || code == PredefinedType.FLOOR
          || code == PredefinedType.ROUND;
    }

    @Override
    Object evaluate(Frame frame) {
      Object value = operand.evaluate(frame);
      return Numbers.isNumber(value) ? ExactNumbers.unary(code, value) : INVALID;
    }
  }
}
