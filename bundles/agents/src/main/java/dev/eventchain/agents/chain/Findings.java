package dev.eventchain.agents.chain;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.documents.Document;
import java.util.ArrayList;
import java.util.List;

/** Collects findings about a JSON text, each with its place. */
final class Findings {
  private final Document text;
  private final List<Diagnostic> diagnostics = new ArrayList<>();

  Findings(Document text) {
    this.text = text;
  }

  void error(String id, String pointer, String message, String hint) {
    diagnostics.add(Diagnostic.error(id, message, text.at(pointer)).withHint(hint));
  }

  void warning(String id, String pointer, String message, String hint) {
    diagnostics.add(Diagnostic.warning(id, message, text.at(pointer)).withHint(hint));
  }

  List<Diagnostic> diagnostics() {
    return List.copyOf(diagnostics);
  }
}
