package dev.eventchain.roads.xml;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.DiagnosticException.Reason;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import java.util.ArrayList;
import java.util.List;

/** The problems of a file, in the order in which they are found. Reading goes on after each. */
public final class Problems {

  /** Errors after which reading ends: more would be of one kind, and nobody reads them. */
  private static final int MOST_ERRORS = 100;

  private static final int MOST_WARNINGS = 100;

  private final List<Diagnostic> found = new ArrayList<>();
  private int errors;

  /** Adds a problem of an element. */
  public void add(Rule rule, CheckedElement element, String message, String hint) {
    add(rule, element.location(), message, hint);
  }

  /**
   * Adds a problem.
   *
   * @throws DiagnosticException with all problems so far, after a hundred errors
   */
  public void add(Rule rule, SourceLocation place, String message, String hint) {
    boolean error = rule.severity() == Severity.ERROR;
    if (!error && found.size() - errors >= MOST_WARNINGS) {
      return;
    }
    found.add(Diagnostic.of(rule, message, place).withHint(hint));
    if (error) {
      errors++;
      if (errors >= MOST_ERRORS) {
        throw failure();
      }
    }
  }

  /** Returns the number of errors so far. */
  public int errors() {
    return errors;
  }

  /**
   * Returns the problems that still allow a result.
   *
   * @throws DiagnosticException with all problems, if any is an error
   */
  public List<Diagnostic> warnings() {
    if (errors > 0) {
      throw failure();
    }
    return List.copyOf(found);
  }

  private DiagnosticException failure() {
    return new DiagnosticException(Reason.INPUT, found);
  }
}
