package dev.eventchain.m2t.report;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Findings of a run. Of repeated findings at one location, only the first are kept. */
final class Findings {
  private static final int KEPT = 20;

  private record Kind(Rule rule, SourceLocation place) {}

  private final List<Diagnostic> found = new ArrayList<>();
  private final Map<Kind, Integer> counts = new LinkedHashMap<>();

  void add(Diagnostic diagnostic) {
    Kind kind = new Kind(diagnostic.kind(), diagnostic.location().withElement(""));
    if (counts.merge(kind, 1, Integer::sum) <= KEPT && !found.contains(diagnostic)) {
      found.add(diagnostic);
    }
  }

  List<Diagnostic> all() {
    List<Diagnostic> all = new ArrayList<>(found);
    counts.forEach(
        (kind, count) -> {
          if (count > KEPT) {
            String message = (count - KEPT) + " more findings at this place are not listed.";
            all.add(Diagnostic.of(kind.rule(), message, kind.place()).withSeverity(Severity.INFO));
          }
        });
    return all;
  }
}
