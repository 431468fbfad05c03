package dev.eventchain.pipeline;

import dev.eventchain.diagnostics.DiagnosticException;

/**
 * Exit codes of the process. Scripts rely on the numbers. A signal ends it with 128 plus the
 * signal's number, Java's default: 129 for SIGHUP, 130 for SIGINT, 143 for SIGTERM.
 */
public final class ExitCode {

  /** Success without errors. */
  public static final int FINE = 0;

  /** An error among the findings, or a negative verdict. */
  public static final int FINDINGS = 1;

  /** Wrong usage of the command, or unreadable input. */
  public static final int INPUT = 2;

  /** A missing prerequisite of the command on this machine. */
  public static final int UNAVAILABLE = 3;

  /** A missing answer; the same command continues when it exists. */
  public static final int WAITING = 4;

  private ExitCode() {}

  /** Returns the exit code of a command that could not continue. */
  public static int of(DiagnosticException.Reason reason) {
    return switch (reason) {
      case FINDINGS -> FINDINGS;
      case INPUT -> INPUT;
      case UNAVAILABLE -> UNAVAILABLE;
      case WAITING -> WAITING;
    };
  }
}
