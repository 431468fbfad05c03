package dev.eventchain.diagnostics.format;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Report;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.diagnostics.Trial;
import dev.eventchain.diagnostics.Xml;
import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;

/**
 * Report as JUnit XML: a test suite for each kind of test and check, a test case for each of them.
 * Two more suites hold the rest: a test case for each file, and one for each id of the remaining
 * findings. Times are simulated ones, and 0 for checks, so that equal inputs give equal bytes.
 */
final class JunitReport {

  private final Report report;
  private final Map<String, Map<String, JunitCase>> suites = new LinkedHashMap<>();
  private final Map<String, JunitCase> byRule = new LinkedHashMap<>();
  private final Map<String, JunitCase> byId = new LinkedHashMap<>();

  private JunitReport(Report report) {
    this.report = report;
  }

  static String render(Report report) {
    return new JunitReport(report).render();
  }

  private String render() {
    Set<Diagnostic> placed = Collections.newSetFromMap(new IdentityHashMap<>());
    for (Trial trial : report.trials()) {
      suite(trial.kind().title()).computeIfAbsent(trial.name(), JunitCase::new).tried(trial);
      placed.addAll(trial.findings());
    }
    for (Coverage.Kind kind : Coverage.Kind.values()) {
      report.coverage().checks().stream().filter(c -> c.kind() == kind).forEach(this::addCheck);
    }
    for (String file : report.coverage().files()) {
      suite("files").computeIfAbsent(file, JunitCase::new);
    }
    for (Diagnostic finding : report.diagnostics()) {
      if (!placed.contains(finding)) {
        caseFor(finding).found(finding);
      }
    }
    for (Suppressions.Suppressed suppressed : report.suppressed()) {
      caseFor(suppressed.finding()).suppressed(suppressed);
    }
    return write();
  }

  private void addCheck(Coverage.Check check) {
    JunitCase added = suite(check.kind().title()).computeIfAbsent(check.name(), JunitCase::new);
    added.evaluated(check.evaluations());
    (check.rule().isEmpty() ? byId : byRule).putIfAbsent(check.name(), added);
  }

  private Map<String, JunitCase> suite(String name) {
    return suites.computeIfAbsent(name, key -> new LinkedHashMap<>());
  }

  private JunitCase caseFor(Diagnostic finding) {
    JunitCase found = byRule.get(finding.rule());
    if (found == null) {
      found = byId.get(finding.id());
    }
    if (found == null) {
      found = suite("files").get(finding.location().file());
    }
    return found != null
        ? found
        : suites
            .computeIfAbsent("other findings", key -> new TreeMap<>())
            .computeIfAbsent(finding.id(), JunitCase::new);
  }

  private String write() {
    suites.values().removeIf(Map::isEmpty);
    StringBuilder xml = new StringBuilder("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    List<JunitCase> all = new ArrayList<>();
    suites.values().forEach(cases -> all.addAll(cases.values()));
    xml.append("<testsuites name=\"eventchain\"").append(counts(all)).append(">\n");
    suites.forEach(
        (name, cases) -> {
          List<JunitCase> inside = List.copyOf(cases.values());
          xml.append("  <testsuite name=\"").append(Xml.attribute(name)).append('"');
          long skipped = inside.stream().filter(JunitCase::skipped).count();
          xml.append(counts(inside)).append(" skipped=\"").append(skipped).append("\">\n");
          inside.forEach(each -> each.write("eventchain." + name.replace(' ', '-'), xml));
          xml.append("  </testsuite>\n");
        });
    return xml.append("</testsuites>\n").toString();
  }

  private static String counts(List<JunitCase> cases) {
    return " tests=\""
        + cases.size()
        + "\" failures=\""
        + cases.stream().filter(JunitCase::failed).count()
        + "\" errors=\"0\""
        + JunitCase.time(cases.stream().mapToDouble(JunitCase::seconds).sum());
  }
}
