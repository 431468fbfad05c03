package dev.eventchain.simulation;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.ObjectReader;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Reads the formulas in the section {@code accept} of a scenario. */
final class FormulasReader {

  private static final String KEY = "formula";
  private static final Signal.Source SIGNALS = new WorldSignals();

  private final SourceText source;
  private final double duration;

  /**
   * A reader.
   *
   * @param source the file, in which the places of problems are looked for
   * @param duration of the scenario, in s
   */
  FormulasReader(SourceText source, double duration) {
    this.source = source;
    this.duration = duration;
  }

  List<FormulaCriterion> read(List<ObjectReader> sections) {
    List<FormulaCriterion> criteria = new ArrayList<>();
    for (ObjectReader section : sections) {
      String name = section.text("name").orElse("").strip();
      if (!section.has(KEY)) {
        String message = "'" + KEY + "' is missing.";
        section.find("scenario.key.missing", message, section.location());
      }
      section
          .text(KEY)
          .flatMap(text -> formula(section, text))
          .map(formula -> new FormulaCriterion(name, formula, section.atKey(KEY)))
          .ifPresent(criteria::add);
      section.refuseOthers();
    }
    return criteria;
  }

  private Optional<Formula> formula(ObjectReader section, String text) {
    try {
      return Optional.of(Formula.parse(range(section.at(KEY), text), SIGNALS, duration));
    } catch (DiagnosticException e) {
      for (Diagnostic problem : e.diagnostics()) {
        SourceLocation place = problem.location().withElement(section.pointerTo(KEY));
        section.find(problem.withLocation(place));
      }
      return Optional.empty();
    }
  }

  /**
   * Where a text stands in the file, whose lines YAML may have folded: the part that has the same
   * characters but for white space. A text with escapes has none, and stands at one place.
   */
  private SourceRange range(SourceLocation place, String text) {
    String file = source.text();
    int start = source.offset(place.line(), place.column());
    if (start < file.length() && "|>".indexOf(file.charAt(start)) >= 0) {
      start = Math.max(start, file.indexOf('\n', start));
    } else if (start < file.length() && "\"'".indexOf(file.charAt(start)) >= 0) {
      start++;
    }
    int end = start;
    for (int i = 0; i < text.length(); i++) {
      if (Character.isWhitespace(text.charAt(i))) {
        continue;
      }
      while (end < file.length() && Character.isWhitespace(file.charAt(end))) {
        end++;
      }
      if (end == file.length() || file.charAt(end) != text.charAt(i)) {
        return SourceText.within(place, text).whole();
      }
      end++;
    }
    return source.range(start, end);
  }
}
