package dev.eventchain.cli;

import dev.eventchain.diagnostics.DiagnosticException;

/**
 * What the process's exit code says. Scripts rely on the numbers. A signal ends it with 128 and the
 * signal's number, as Java does by itself: 129 for SIGHUP, 130 for SIGINT, 143 for SIGTERM.
 */
final class ExitCode {

  /** Everything was done, and nothing is wrong. */
  static final int FINE = 0;

  /** A finding is an error, or a verdict is negative. */
  static final int FINDINGS = 1;

  /** The command was used wrongly, or its input cannot be read. */
  static final int INPUT = 2;

  /** This machine lacks something that the command needs. */
  static final int UNAVAILABLE = 3;

  /** An answer is awaited; the same command continues when it is there. */
  static final int WAITING = 4;

  private ExitCode() {}

  static int of(DiagnosticException.Reason reason) {
    return switch (reason) {
      case FINDINGS -> FINDINGS;
      case INPUT -> INPUT;
      case UNAVAILABLE -> UNAVAILABLE;
      case WAITING -> WAITING;
    };
  }
}
