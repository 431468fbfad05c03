package dev.eventchain.m2t.syntax;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import java.util.List;

/** Collects what the stages of one compilation unit find wrong with it. */
public record Problems(SourceText source, List<Diagnostic> found) {
  static final String SYNTAX = "m2t.syntax";

  /** A file with more is not a template. */
  private static final int MOST = 1000;

  public void syntax(int offset, String message, String hint) {
    error(SYNTAX, offset, message, hint);
  }

  public void error(String id, int offset, String message, String hint) {
    if (found.size() < MOST) {
      found.add(Diagnostic.error(id, message, source.at(offset)).withHint(hint));
    } else if (found.size() == MOST) {
      String more = "There are more than " + MOST + " problems; the others are not listed.";
      found.add(Diagnostic.error(SYNTAX, more, source.at(offset)));
    }
  }

  /** Whether no more problems are listed, so that looking for them is in vain. */
  boolean areTooMany() {
    return found.size() > MOST;
  }

  public void warning(String id, int offset, String message, String hint) {
    found.add(Diagnostic.warning(id, message, source.at(offset)).withHint(hint));
  }
}
