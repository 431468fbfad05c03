package dev.eventchain.pipeline;

import dev.eventchain.diagnostics.DiagnosticException;

/**
 * What the process's exit code means. Scripts rely on the numbers. A signal ends it with 128 and
 * the signal's number, as Java does by itself: 129 for SIGHUP, 130 for SIGINT, 143 for SIGTERM.
 */
public final class ExitCode {

  /** Everything was done, and nothing is wrong. */
  public static final int FINE = 0;

  /** A finding is an error, or a verdict is negative. */
  public static final int FINDINGS = 1;

  /** The command was used wrongly, or its input cannot be read. */
  public static final int INPUT = 2;

  /** This machine lacks something that the command needs. */
  public static final int UNAVAILABLE = 3;

  /** An answer is awaited; the same command continues when it is there. */
  public static final int WAITING = 4;

  private ExitCode() {}

  /** The code of a command that could not go on. */
  public static int of(DiagnosticException.Reason reason) {
    return switch (reason) {
      case FINDINGS -> FINDINGS;
      case INPUT -> INPUT;
      case UNAVAILABLE -> UNAVAILABLE;
      case WAITING -> WAITING;
    };
  }
}
