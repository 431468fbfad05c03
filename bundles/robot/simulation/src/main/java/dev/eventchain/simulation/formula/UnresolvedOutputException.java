package dev.eventchain.simulation.formula;

/** There is no single output of the software that a formula can mean by {@code output(ID)}. */
public final class UnresolvedOutputException extends RuntimeException {

  private static final long serialVersionUID = 1L;

  /**
   * Creates the exception.
   *
   * @param reason for users, as a part of a sentence
   */
  UnresolvedOutputException(String reason) {
    super(reason);
  }
}
