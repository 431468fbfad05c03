package dev.eventchain.openscenario.expression;

import java.util.Locale;

/** A value in an expression. */
public sealed interface Operand {

  /** Returns the value as an attribute has it. */
  String text();

  /** Returns the number, or refuses for what is said to need one. */
  default double number(String user) throws ExpressionException {
    throw new ExpressionException("`" + user + "` needs numbers, not `" + text() + "`.");
  }

  /** Returns the truth value, or refuses for what is said to need one. */
  default boolean truth(String user) throws ExpressionException {
    throw new ExpressionException("`" + user + "` needs Booleans, not `" + text() + "`.");
  }

  /** A finite number; whole numbers are numbers as well. */
  record Numeric(double value) implements Operand {

    private static final double LARGEST_WITHOUT_EXPONENT = 1e15;

    @Override
    public String text() {
      boolean whole = value == Math.rint(value) && Math.abs(value) < LARGEST_WITHOUT_EXPONENT;
      return whole ? String.format(Locale.ROOT, "%d", (long) value) : Double.toString(value);
    }

    @Override
    public double number(String user) {
      return value;
    }
  }

  /** A truth value. */
  record Truth(boolean value) implements Operand {

    @Override
    public String text() {
      return Boolean.toString(value);
    }

    @Override
    public boolean truth(String user) {
      return value;
    }
  }

  /** Any other value of a parameter, with which nothing can be computed. */
  record Text(String text) implements Operand {}
}
