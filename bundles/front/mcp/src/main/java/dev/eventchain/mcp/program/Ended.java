package dev.eventchain.mcp.program;

/**
 * The end of a command.
 *
 * @param code its exit code
 * @param out what it printed to standard output
 * @param err the lines of standard error that stay
 */
public record Ended(int code, String out, String err) {

  private static final int WRONG_USE = 2;

  /** Returns whether the command did its work; it may have found that something is wrong. */
  public boolean worked() {
    return code < WRONG_USE;
  }
}
