package dev.eventchain.openscenario.document;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/** The findings of one reading; what is found twice is one finding. */
final class Findings {

  private static final int MOST = 200;

  private final Set<Diagnostic> found = new LinkedHashSet<>();

  void add(Rule rule, String message, SourceLocation place, String hint) {
    if (!isFull()) {
      found.add(Diagnostic.of(rule, message, place).withHint(hint));
    }
  }

  /** Returns whether no more findings are kept, so that hints need not be thought of. */
  boolean isFull() {
    return found.size() >= MOST;
  }

  void addAll(Iterable<Diagnostic> others) {
    others.forEach(found::add);
  }

  List<Diagnostic> all() {
    return List.copyOf(found);
  }

  /**
   * Ends the reading if there is an error.
   *
   * @return the warnings
   */
  List<Diagnostic> endIfWrong() {
    List<Diagnostic> all = new ArrayList<>(found);
    if (Diagnostic.anyError(all)) {
      throw new DiagnosticException(DiagnosticException.Reason.FINDINGS, all);
    }
    return all;
  }

  /** Returns the exception of a single finding. */
  static DiagnosticException refused(Rule rule, String message, SourceLocation place, String hint) {
    return new DiagnosticException(
        DiagnosticException.Reason.FINDINGS, Diagnostic.of(rule, message, place).withHint(hint));
  }
}
