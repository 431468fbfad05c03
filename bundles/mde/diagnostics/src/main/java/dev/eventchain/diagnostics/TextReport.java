package dev.eventchain.diagnostics;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;

/** Report as plain text. */
final class TextReport {

  private static final int LONGEST_EXCERPT = 160;

  private TextReport() {}

  /** Returns the whole report, with the summary if anything was checked. */
  static String render(Report report) {
    String findings = findings(report, Integer.MAX_VALUE);
    return report.coverage().equals(Coverage.NONE) ? findings : findings + report.summary() + "\n";
  }

  static String findings(Report report, int mostOfOneRule) {
    StringBuilder text = new StringBuilder();
    Map<String, Integer> shown = new HashMap<>();
    Map<String, Integer> more = new LinkedHashMap<>();
    for (Diagnostic diagnostic : report.diagnostics()) {
      String rule = ruleOf(diagnostic);
      if (shown.merge(rule, 1, Integer::sum) <= mostOfOneRule) {
        append(diagnostic, text);
      } else {
        more.merge(rule, 1, Integer::sum);
      }
    }
    more.forEach(
        (rule, count) ->
            text.append("... and ").append(count).append(" more [").append(rule).append("]\n"));
    return text.toString();
  }

  /** Appends a finding with its location, source line and hint. */
  static void append(Diagnostic diagnostic, StringBuilder text) {
    SourceLocation location = diagnostic.location();
    String place = location.toString();
    if (!place.isEmpty()) {
      text.append(Printable.lines(place)).append(": ");
    }
    text.append(diagnostic.severity()).append(": ").append(Printable.lines(diagnostic.message()));
    text.append(" [").append(ruleOf(diagnostic)).append("]\n");
    appendExcerpt(location, text);
    if (!location.element().isEmpty()) {
      text.append("  at: ").append(Printable.lines(location.element())).append('\n');
    }
    for (SourceLocation related : diagnostic.related()) {
      text.append("  see: ").append(Printable.lines(nameOf(related))).append('\n');
    }
    if (!diagnostic.hint().isEmpty()) {
      text.append("  hint: ").append(Printable.lines(diagnostic.hint())).append('\n');
    }
  }

  private static String ruleOf(Diagnostic diagnostic) {
    String rule = diagnostic.rule().isEmpty() ? "" : " " + Printable.lines(diagnostic.rule());
    return diagnostic.id() + rule;
  }

  /** Returns the location, or the element if no location is known. */
  private static String nameOf(SourceLocation related) {
    return related.toString().isEmpty() ? related.element() : related.toString();
  }

  private static void appendExcerpt(SourceLocation location, StringBuilder text) {
    String excerpt = location.excerpt();
    if (excerpt.isBlank() || location.line() == 0) {
      return;
    }
    int column = Math.min(Math.max(location.column(), 1), excerpt.length() + 1) - 1;
    int from =
        Math.max(0, Math.min(column - LONGEST_EXCERPT / 2, excerpt.length() - LONGEST_EXCERPT));
    int to = Math.min(excerpt.length(), from + LONGEST_EXCERPT);
    text.append("    ").append(Printable.excerpt(excerpt.substring(from, to))).append('\n');
    if (location.column() > 0) {
      text.append("    ");
      for (int i = from; i < column; i++) {
        text.append(excerpt.charAt(i) == '\t' ? '\t' : ' ');
      }
      text.append("^\n");
    }
  }
}
