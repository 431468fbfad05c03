package dev.eventchain.maven;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Printable;
import dev.eventchain.diagnostics.format.FindingExcerpt;
import java.util.List;
import org.apache.maven.plugin.logging.Log;

/** Findings as lines of Maven's log, each at the level of its severity. */
final class FindingLines {

  /** Largest number of findings of one rule that is printed; a report has all. */
  private static final int MOST_OF_ONE_RULE = 100;

  private final Log log;

  FindingLines(Log log) {
    this.log = log;
  }

  void print(List<Diagnostic> findings) {
    FindingExcerpt excerpt = FindingExcerpt.of(findings, MOST_OF_ONE_RULE);
    excerpt.shown().forEach(this::print);
    excerpt.more().forEach((rule, count) -> log.warn("... and " + count + " more [" + rule + "]"));
  }

  private void print(FindingExcerpt.Shown shown) {
    Diagnostic finding = shown.finding();
    print(finding, line(finding));
    String element = finding.location().element();
    if (!element.isEmpty()) {
      print(finding, "  at: " + clean(element));
    }
    if (!finding.hint().isEmpty()) {
      print(finding, "  hint: " + clean(finding.hint()));
    }
    if (!shown.consequences().isEmpty()) {
      print(finding, "  " + clean(shown.words()));
    }
  }

  private void print(Diagnostic finding, String line) {
    switch (finding.severity()) {
      case ERROR -> log.error(line);
      case WARNING -> log.warn(line);
      case INFO -> log.info(line);
    }
  }

  /** Returns the finding in a line: {@code file:line:column: message [id rule]}. */
  static String line(Diagnostic finding) {
    String place = finding.location().toString();
    return (place.isEmpty() ? "" : clean(place) + ": ")
        + clean(finding.message())
        + " ["
        + FindingExcerpt.ruleOf(finding)
        + "]";
  }

  /** Escapes line breaks so that no line can pass for one of Maven's. */
  private static String clean(String text) {
    return Printable.clean(text).replace("\n", "\n    | ");
  }
}
