package dev.eventchain.diagnostics.format;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Printable;
import dev.eventchain.diagnostics.Report;
import dev.eventchain.diagnostics.SourceLocation;
import java.util.List;

/** Report as plain text. */
final class TextReport {

  private static final int LONGEST_EXCERPT = 160;

  private TextReport() {}

  /** Returns the whole report, with the summary if anything was checked. */
  static String render(Report report) {
    String findings = findings(report.diagnostics());
    return report.coverage().equals(Coverage.NONE) ? findings : findings + report.summary() + "\n";
  }

  static String findings(List<Diagnostic> findings) {
    StringBuilder text = new StringBuilder();
    findings.forEach(each -> append(each, text));
    return text.toString();
  }

  static String excerpt(FindingExcerpt excerpt) {
    StringBuilder text = new StringBuilder();
    for (FindingExcerpt.Shown each : excerpt.shown()) {
      append(each.finding(), text);
      if (!each.consequences().isEmpty()) {
        text.append("  ").append(Printable.lines(each.words())).append('\n');
      }
    }
    excerpt
        .more()
        .forEach(
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
    text.append(" [").append(FindingExcerpt.ruleOf(diagnostic)).append("]\n");
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
