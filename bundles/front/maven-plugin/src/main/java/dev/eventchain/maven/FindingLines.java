package dev.eventchain.maven;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Printable;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
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
    Map<String, Integer> shown = new HashMap<>();
    Map<String, Integer> more = new LinkedHashMap<>();
    for (Diagnostic finding : findings) {
      if (shown.merge(rule(finding), 1, Integer::sum) <= MOST_OF_ONE_RULE) {
        print(finding);
      } else {
        more.merge(rule(finding), 1, Integer::sum);
      }
    }
    more.forEach((rule, count) -> log.warn("... and " + count + " more " + rule));
  }

  private void print(Diagnostic finding) {
    print(finding, line(finding));
    String element = finding.location().element();
    if (!element.isEmpty()) {
      print(finding, "  at: " + clean(element));
    }
    if (!finding.hint().isEmpty()) {
      print(finding, "  hint: " + clean(finding.hint()));
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
        + " "
        + rule(finding);
  }

  private static String rule(Diagnostic finding) {
    return "[" + finding.id() + (finding.rule().isEmpty() ? "" : " " + clean(finding.rule())) + "]";
  }

  /** Escapes line breaks so that no line can pass for one of Maven's. */
  private static String clean(String text) {
    return Printable.clean(text).replace("\n", "\n    | ");
  }
}
