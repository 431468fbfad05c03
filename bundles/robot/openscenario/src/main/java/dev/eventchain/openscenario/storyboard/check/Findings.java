package dev.eventchain.openscenario.storyboard.check;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.openscenario.document.ScenarioElement;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.stream.Stream;

/** Collects findings about a scenario. */
final class Findings {

  private final List<Diagnostic> all = new ArrayList<>();

  void add(Rule rule, SourceLocation place, String message, String hint) {
    all.add(Diagnostic.of(rule, message, place).withHint(hint));
  }

  void addAll(List<Diagnostic> findings) {
    all.addAll(findings);
  }

  /** Returns the findings in the order of the file. */
  List<Diagnostic> sorted() {
    List<Diagnostic> sorted = new ArrayList<>(all);
    Collections.sort(sorted);
    return sorted;
  }

  /** Returns an element and all elements in it, in their order. */
  static Stream<ScenarioElement> within(ScenarioElement element) {
    return Stream.concat(Stream.of(element), element.children().stream().flatMap(Findings::within));
  }
}
