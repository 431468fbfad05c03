package dev.eventchain.openscenario.expression;

/** Thrown where an expression is wrong or has no value; the message is a sentence. */
public final class ExpressionException extends Exception {

  private static final long serialVersionUID = 1L;

  ExpressionException(String message) {
    super(message);
  }
}
