package dev.eventchain.m2t;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import java.util.List;

/** Where the stages of one compilation unit put what they find wrong with it. */
record Problems(SourceText source, List<Diagnostic> found) {
  static final String SYNTAX = "m2t.syntax";

  void syntax(int offset, String message, String hint) {
    error(SYNTAX, offset, message, hint);
  }

  void error(String id, int offset, String message, String hint) {
    found.add(Diagnostic.error(id, message, source.at(offset)).withHint(hint));
  }

  void warning(String id, int offset, String message, String hint) {
    found.add(Diagnostic.warning(id, message, source.at(offset)).withHint(hint));
  }
}
