package dev.eventchain.ocl;

import org.eclipse.emf.ecore.EEnumLiteral;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.impl.BasicEObjectImpl;
import org.eclipse.emf.ecore.impl.EEnumLiteralImpl;
import org.eclipse.ocl.util.ObjectUtil;

/** Logic with null and invalid, equality, and the tests for null and invalid. */
final class LogicNodes {

  private LogicNodes() {}

  /** A node with a left and a right side. */
  abstract static class Binary extends Node {
    final Node left;
    final Node right;

    Binary(Node left, Node right) {
      this.left = left;
      this.right = right;
    }
  }

  /** {@code and}: false on either side decides, whatever the other one is. */
  static final class And extends Binary {
    And(Node left, Node right) {
      super(left, right);
    }

    @Override
    Object evaluate(Frame frame) {
      Object first = left.evaluate(frame);
      if (Boolean.FALSE.equals(first)) {
        return false;
      }
      Object second = right.evaluate(frame);
      if (Boolean.FALSE.equals(second)) {
        return false;
      }
      return isUndefined(first) || isUndefined(second) ? INVALID : (Object) true;
    }
  }

  /** {@code or}: true on either side decides, whatever the other one is. */
  static final class Or extends Binary {
    Or(Node left, Node right) {
      super(left, right);
    }

    @Override
    Object evaluate(Frame frame) {
      Object first = left.evaluate(frame);
      if (Boolean.TRUE.equals(first)) {
        return true;
      }
      Object second = right.evaluate(frame);
      if (Boolean.TRUE.equals(second)) {
        return true;
      }
      return isUndefined(first) || isUndefined(second) ? INVALID : (Object) false;
    }
  }

  /** {@code implies}: a false left side or a true right side decides. */
  static final class Implies extends Binary {
    Implies(Node left, Node right) {
      super(left, right);
    }

    @Override
    Object evaluate(Frame frame) {
      Object first = left.evaluate(frame);
      if (Boolean.FALSE.equals(first)) {
        return true;
      }
      Object second = right.evaluate(frame);
      if (Boolean.TRUE.equals(second)) {
        return true;
      }
      return isUndefined(first) || isUndefined(second) ? INVALID : second;
    }
  }

  /** {@code xor}. */
  static final class Xor extends Binary {
    Xor(Node left, Node right) {
      super(left, right);
    }

    @Override
    Object evaluate(Frame frame) {
      Object first = left.evaluate(frame);
      Object second = right.evaluate(frame);
      return first instanceof Boolean one && second instanceof Boolean other
          ? (Object) (one ^ other)
          : INVALID;
    }
  }

  /** {@code not}. */
  static final class Not extends Node {
    private final Node operand;

    Not(Node operand) {
      this.operand = operand;
    }

    @Override
    Object evaluate(Frame frame) {
      return operand.evaluate(frame) instanceof Boolean value ? (Object) !value : INVALID;
    }
  }

  /** {@code =} and {@code <>}: null equals null, and invalid makes the result invalid. */
  static final class Equality extends Binary {
    private final boolean wanted;
    private final StockOperation stock;

    Equality(Node left, Node right, boolean wanted, StockOperation stock) {
      super(left, right);
      this.wanted = wanted;
      this.stock = stock;
    }

    @Override
    Object evaluate(Frame frame) {
      Object first = left.evaluate(frame);
      if (first == INVALID) {
        return INVALID;
      }
      Object second = right.evaluate(frame);
      if (second == INVALID) {
        return INVALID;
      } else if (first == null || second == null) {
        return (first == second) == wanted;
      } else if (first instanceof String || isPlainObject(first)) {
        return first.equals(second) == wanted;
      } else if (first instanceof Integer one && second instanceof Integer other) {
        return (one.intValue() == other.intValue()) == wanted;
      } else if (isRareNumber(first) || isRareNumber(second)) {
        return stock.apply(frame, first, second);
      }
      return ObjectUtil.equal(first, second) == wanted;
    }

    /** An object is equal to itself only; a literal of an enumeration also to its Java value. */
    static boolean isPlainObject(Object value) {
      return value instanceof BasicEObjectImpl
          ? !(value instanceof EEnumLiteralImpl)
          : value instanceof EObject && !(value instanceof EEnumLiteral);
    }

    /** A number of a Java type that Eclipse OCL converts before it compares. */
    private static boolean isRareNumber(Object value) {
      return value instanceof Number
          && !(value instanceof Integer || value instanceof Double || value instanceof Long);
    }
  }

  /** {@code oclIsUndefined()} and {@code oclIsInvalid()}. */
  static final class IsUndefined extends Node {
    private final Node operand;
    private final boolean orNull;

    IsUndefined(Node operand, boolean orNull) {
      this.operand = operand;
      this.orNull = orNull;
    }

    @Override
    Object evaluate(Frame frame) {
      Object value = operand.evaluate(frame);
      return value == INVALID || (orNull && value == null);
    }
  }
}
