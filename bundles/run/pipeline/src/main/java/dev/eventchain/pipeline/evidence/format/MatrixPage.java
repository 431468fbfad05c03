package dev.eventchain.pipeline.evidence.format;

import dev.eventchain.pipeline.evidence.Evidence;
import dev.eventchain.pipeline.evidence.Evidence.Component;
import dev.eventchain.pipeline.evidence.Evidence.Requirement;
import dev.eventchain.pipeline.evidence.Evidence.Result;
import dev.eventchain.pipeline.evidence.Evidence.Strength;
import dev.eventchain.pipeline.evidence.Evidence.Test;
import dev.eventchain.pipeline.evidence.Evidence.Verdict;
import dev.eventchain.pipeline.report.StaticPage;
import java.util.List;

/** A page with a row for each requirement: its verdict, strength, components, tests, scenarios. */
final class MatrixPage {

  private static final String STYLE =
      """
      .matrix { width: 100%; border-collapse: collapse; margin-top: 1.5rem; overflow-wrap: break-word; }
      .matrix th { text-align: left; font-size: .8125rem; color: var(--muted); }
      .matrix th, .matrix td { padding: .5rem .75rem .5rem 0; vertical-align: top; }
      .matrix td { border-top: 1px solid var(--line); }
      .matrix li + li { margin-top: .15rem; }
      .matrix td:first-child { min-width: 14rem; max-width: 24rem; }
      .matrix td:nth-child(4) { white-space: nowrap; }
      .matrix td:last-child { width: 40%; }
      .mark { display: inline-block; padding: 0 .4em; border-radius: .25em; font-size: .8125rem; white-space: nowrap; }
      .is-good { background: var(--good-soft); color: var(--good); }
      .is-bad { background: var(--bad-soft); color: var(--bad); }
      .is-open { background: var(--warn-soft); color: var(--warn); }
      """;

  private final Evidence evidence;
  private final StaticPage page;

  private MatrixPage(Evidence evidence) {
    this.evidence = evidence;
    this.page = new StaticPage("Evidence · " + evidence.title(), STYLE);
  }

  static String render(Evidence evidence) {
    MatrixPage matrix = new MatrixPage(evidence);
    matrix.page.add("<p class=\"kicker\">Eventchain evidence · %s</p>\n", evidence.name());
    matrix.page.add("<h1>%s</h1>\n<p>%s</p>\n", evidence.title(), evidence.summary());
    matrix.table();
    return matrix.page.end(
        "What was not tested is neither passed nor failed. A test that passed counts for a"
            + " requirement only if the requirement is proved.");
  }

  private void table() {
    if (evidence.requirements().isEmpty()) {
      page.raw("<p>There is no requirement.</p>\n");
      return;
    }
    page.raw("<table class=\"matrix\">\n<thead><tr><th>Requirement</th><th>Verdict</th>");
    page.raw("<th>Strength</th><th>Components</th><th>Component tests</th><th>Scenarios</th>");
    page.raw("</tr></thead>\n<tbody>\n");
    evidence.requirements().forEach(this::row);
    page.raw("</tbody>\n</table>\n");
  }

  private void row(Requirement requirement) {
    page.add("<tr><td><b>%s</b> %s</td>", requirement.id(), requirement.text());
    page.raw("<td>");
    mark(style(requirement.verdict()), requirement.verdict().words());
    page.add(" %s", requirement.reason().orElse(""));
    page.add(
        "</td><td>%s</td>", requirement.strength().map(Strength::words).orElse("not measured"));
    page.raw("<td><ul>");
    for (Component component : evidence.componentsOf(requirement.id())) {
      page.add("<li>%s</li>", component.name());
    }
    page.raw("</ul></td>");
    List<Test> about =
        evidence.tests().stream().filter(each -> each.about(requirement.id()).isPresent()).toList();
    tests(requirement, about.stream().filter(each -> each.component().isPresent()).toList(), false);
    tests(requirement, about.stream().filter(each -> each.component().isEmpty()).toList(), true);
    page.raw("</tr>\n");
  }

  /** Adds what did not pass, and then how many passed, by name if they are to be named. */
  private void tests(Requirement requirement, List<Test> tests, boolean named) {
    page.raw("<td><ul>");
    tests.stream()
        .filter(each -> result(each, requirement) != Result.PASSED)
        .forEach(each -> item(each, requirement));
    List<String> passed =
        tests.stream()
            .filter(each -> result(each, requirement) == Result.PASSED)
            .map(Test::fullName)
            .toList();
    if (!passed.isEmpty()) {
      page.raw("<li>");
      mark("is-good", passed.size() + " passed");
      page.add(" %s</li>", named ? String.join(", ", passed) : "");
    }
    page.raw("</ul></td>");
  }

  private void item(Test test, Requirement requirement) {
    Result result = result(test, requirement);
    page.raw("<li>");
    mark(style(result), result.words());
    page.add(" %s</li>", test.fullName() + (test.text().isEmpty() ? "" : ": " + test.text()));
  }

  private void mark(String style, String words) {
    page.add("<span class=\"mark %s\">%s</span>", style, words);
  }

  private static Result result(Test test, Requirement requirement) {
    return test.about(requirement.id()).orElseThrow();
  }

  private static String style(Verdict verdict) {
    return switch (verdict) {
      case PROVED -> "is-good";
      case VIOLATED -> "is-bad";
      case NOT_TESTED -> "is-open";
    };
  }

  private static String style(Result result) {
    return switch (result) {
      case PASSED -> "is-good";
      case FAILED -> "is-bad";
      case NOT_TESTED -> "is-open";
    };
  }
}
