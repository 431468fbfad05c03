package dev.eventchain.agents.chain;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Rule;
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

  void add(Rule rule, String pointer, String message, String hint) {
    diagnostics.add(Diagnostic.of(rule, message, text.at(pointer)).withHint(hint));
  }

  List<Diagnostic> diagnostics() {
    return List.copyOf(diagnostics);
  }
}
