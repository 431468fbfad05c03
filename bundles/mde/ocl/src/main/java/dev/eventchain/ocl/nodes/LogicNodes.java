package dev.eventchain.ocl.nodes;

import dev.eventchain.ocl.values.Values;

/** Logic with null and invalid, equality, and the tests for null and invalid. */
public final class LogicNodes {

  private LogicNodes() {}

  /** A node with a left and a right side. */
  public abstract static class Binary extends Node {
    final Node left;
    final Node right;

    Binary(Node left, Node right) {
      this.left = left;
      this.right = right;
    }

    /** Returns the left side. */
    public Node left() {
      return left;
    }

    /** Returns the right side. */
    public Node right() {
      return right;
    }
  }

  /** {@code and}: false on either side decides, whatever the other side is. */
  public static final class And extends Binary {
    public And(Node left, Node right) {
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
      return Boolean.TRUE.equals(first) && Boolean.TRUE.equals(second) ? (Object) true : INVALID;
    }
  }

  /** {@code or}: true on either side decides, whatever the other side is. */
  public static final class Or extends Binary {
    public Or(Node left, Node right) {
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
      return Boolean.FALSE.equals(first) && Boolean.FALSE.equals(second) ? (Object) false : INVALID;
    }
  }

  /** {@code implies}: a false left side or a true right side decides. */
  public static final class Implies extends Binary {
    public Implies(Node left, Node right) {
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
      return Boolean.TRUE.equals(first) && Boolean.FALSE.equals(second) ? (Object) false : INVALID;
    }
  }

  /** {@code xor}. */
  public static final class Xor extends Binary {
    public Xor(Node left, Node right) {
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
  public static final class Not extends Node {
    private final Node operand;

    public Not(Node operand) {
      this.operand = operand;
    }

    @Override
    Object evaluate(Frame frame) {
      return operand.evaluate(frame) instanceof Boolean value ? (Object) !value : INVALID;
    }
  }

  /** {@code =} and {@code <>}: null equals null, and invalid makes the result invalid. */
  public static final class Equality extends Binary {
    private final boolean wanted;

    public Equality(Node left, Node right, boolean wanted) {
      super(left, right);
      this.wanted = wanted;
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
      }
      return Values.equal(first, second) == wanted;
    }
  }

  /** {@code oclIsUndefined()} and {@code oclIsInvalid()}. */
  public static final class IsUndefined extends Node {
    private final Node operand;
    private final boolean orNull;

    public IsUndefined(Node operand, boolean orNull) {
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
