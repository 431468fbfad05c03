package dev.eventchain.diagnostics;

import java.util.List;

/**
 * A stage could not make its result, and these findings say why. Findings that leave a result stand
 * in the result instead.
 */
public final class DiagnosticException extends RuntimeException {

  private static final long serialVersionUID = 1L;

  /** Why there is no result, which decides how a command ends. */
  public enum Reason {
    /** The input was read and found wanting. */
    FINDINGS,
    /** The input could not be read, or the command was used wrongly. */
    INPUT,
    /** This machine lacks something. */
    UNAVAILABLE,
    /** An answer is awaited from outside. */
    WAITING
  }

  private final Reason reason;
  private final transient List<Diagnostic> diagnostics;

  /**
   * Says why there is no result.
   *
   * @param diagnostics the findings, at least one, of which one is an error
   */
  public DiagnosticException(Reason reason, List<Diagnostic> diagnostics) {
    super(summary(diagnostics));
    this.reason = reason;
    this.diagnostics = List.copyOf(diagnostics);
  }

  /** As {@link #DiagnosticException(Reason, List)} with a single finding. */
  public DiagnosticException(Reason reason, Diagnostic diagnostic) {
    this(reason, List.of(diagnostic));
  }

  /** Why there is no result. */
  public Reason reason() {
    return reason;
  }

  /** What was found, in the order of discovery; at least one. */
  public List<Diagnostic> diagnostics() {
    return diagnostics;
  }

  private static String summary(List<Diagnostic> diagnostics) {
    if (diagnostics.isEmpty()) {
      throw new IllegalArgumentException("a failure needs a finding");
    }
    Diagnostic first = diagnostics.get(0);
    return first.location() + ": " + first.message() + " [" + first.id() + "]";
  }
}
