package dev.eventchain.pipeline.evaluation;

import dev.eventchain.pipeline.evaluation.EvaluatedRun.Grade;
import dev.eventchain.pipeline.evaluation.EvaluatedRun.Score;
import dev.eventchain.pipeline.evaluation.EvaluationRow.Rate;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.report.ReportPage;
import dev.eventchain.pipeline.report.StaticPage;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

/** The results of an evaluation as one HTML file without scripts. */
final class EvaluationPage {

  private static final List<String> TITLES = List.of("Chain model", "Function code", "Overall");
  private static final String HOW_TO_READ =
      "A chain model counts if design, model and constraints passed their checks and validation"
          + " finds no error; function code if the components that the model was to write pass"
          + " theirs; overall if all of that holds and the verdict of the scenarios is PASSED."
          + " Intervals are 95 % Wilson intervals.";

  private final Project project;
  private final EvaluationOptions options;
  private final List<EvaluationRow> rows;
  private final List<EvaluatedRun> runs;
  private final StaticPage page;

  private EvaluationPage(
      Project project,
      EvaluationOptions options,
      List<EvaluationRow> rows,
      List<EvaluatedRun> runs) {
    this.project = project;
    this.options = options;
    this.rows = rows;
    this.runs = runs;
    this.page = new StaticPage("Evaluation · " + project.configuration().title(), "");
  }

  static String of(
      Project project,
      EvaluationOptions options,
      List<EvaluationRow> rows,
      List<EvaluatedRun> runs) {
    EvaluationPage page = new EvaluationPage(project, options, rows, runs);
    page.head();
    page.conclusion();
    if (page.anyCounted()) {
      page.rates();
      page.tasks();
      page.failures();
    }
    page.allRuns();
    return page.page.end(HOW_TO_READ);
  }

  private boolean anyCounted() {
    return runs.stream().anyMatch(EvaluatedRun::isCounted);
  }

  private void head() {
    add("<p class=\"kicker\">Eventchain evaluation · %s</p>\n", project.configuration().name());
    add("<h1>%s: language models compared</h1>\n", project.configuration().title());
  }

  /** Writes the statement that precedes all numbers. */
  private void conclusion() {
    String label = EvaluationText.label(rows);
    if (!label.isEmpty()) {
      add("<div class=\"verdict incomplete\"><p class=\"word\">No evaluation</p>");
      add("<p class=\"summary\">%s</p></div>\n", label);
    }
    if (!anyCounted()) {
      add("<div class=\"verdict failed\"><p class=\"word\">Nothing was counted</p>");
      add(
          "<p class=\"summary\">No run counts, so nothing can be said about any model.</p></div>\n");
    }
    long counted = runs.stream().filter(EvaluatedRun::isCounted).count();
    add("<dl class=\"figures\">");
    figure("Runs that count", String.format(Locale.ROOT, "%d of %d", counted, runs.size()));
    figure("Runs of each model", Integer.toString(options.runs()));
    figure("Answers by", options.kindOfSource(project));
    add("</dl>\n");
  }

  private void figure(String name, String value) {
    add("<div><dt>%s</dt><dd>%s</dd></div>", name, value);
  }

  private void rates() {
    add("<section id=\"rates\"><h2>How often it was right</h2>\n");
    add("<div class=\"scroll\"><table>\n<thead><tr><th>Model</th><th>Answers</th>");
    TITLES.forEach(title -> add("<th>%s</th>", title));
    add("</tr></thead>\n");
    for (EvaluationRow row : rows) {
      boolean judged = !row.counted().isEmpty();
      add(judged ? "<tbody><tr><th scope=\"rowgroup\" rowspan=\"2\">" : "<tbody><tr><th>");
      add("%s", row.model());
      add("<div class=\"muted small\">%s</div></th>", String.join("; ", facts(row)));
      if (!judged) {
        add("<td colspan=\"4\" class=\"none\">nothing to judge</td></tr></tbody>\n");
        continue;
      }
      cells("first only", row, false);
      add("</tr>\n<tr>");
      cells("after repair", row, true);
      add("</tr></tbody>\n");
    }
    add("</table></div></section>\n");
  }

  private List<String> facts(EvaluationRow row) {
    List<String> facts = new ArrayList<>();
    if (row.authored()) {
      facts.add(EvaluationText.LABEL);
    }
    facts.addAll(EvaluationText.facts(row, project.configuration()));
    return facts;
  }

  private void cells(String answers, EvaluationRow row, boolean repaired) {
    add("<td class=\"muted\">%s</td>", answers);
    for (Function<EvaluatedRun, Score> artefact : EvaluationRow.ARTEFACTS.values()) {
      Rate rate = row.rate(artefact, repaired);
      add("<td>%s", EvaluationText.cell(rate));
      rate.interval().ifPresent(interval -> picture(rate, interval));
      add("</td>");
    }
  }

  /** Adds the interval on a line from 0 to 1 with the rate. */
  private void picture(Rate rate, WilsonInterval interval) {
    add(
        "<svg class=\"ranges\" viewBox=\"-1 0 102 10\" preserveAspectRatio=\"none\""
            + " aria-hidden=\"true\">");
    add("<line class=\"base\" x1=\"0\" x2=\"100\" y1=\"5\" y2=\"5\"/>");
    String low = percent(interval.low());
    String high = percent(interval.high());
    add("<line class=\"span\" x1=\"%s\" x2=\"%s\" y1=\"5\" y2=\"5\"/>", low, high);
    String at = percent((double) rate.passed() / rate.of() - 0.005);
    add("<rect class=\"median\" x=\"%s\" y=\"1\" width=\"1\" height=\"8\"/></svg>", at);
  }

  private static String percent(double value) {
    return String.format(Locale.ROOT, "%.1f", value * 100);
  }

  private void failures() {
    add("<section id=\"failures\"><h2>What was wrong</h2>\n");
    add(
        "<p class=\"lead\">Failures by stage and finding, with the number of runs; repairs by"
            + " task and error.</p>\n");
    add("<div class=\"scroll\"><table>\n<thead><tr><th>Model</th><th>Failed by</th>");
    add("<th>Sent back, and right in the next answer</th></tr></thead>\n<tbody>\n");
    for (EvaluationRow row : rows) {
      if (!row.counted().isEmpty()) {
        add("<tr><th scope=\"row\">%s%s</th>", row.model(), row.authored() ? " (authored)" : "");
        classes(row.classes(EvaluatedRun::failures));
        repairs(row.repairs());
        add("</tr>\n");
      }
    }
    add("</tbody></table></div></section>\n");
  }

  private void repairs(List<RepairResult> repairs) {
    if (repairs.isEmpty()) {
      add("<td class=\"none\">nothing</td>");
      return;
    }
    add("<td><ul>");
    for (RepairResult each : repairs) {
      add("<li><code>%s</code> %s of %s</li>", each.error(), each.right(), each.sentBack());
    }
    add("</ul></td>");
  }

  private void tasks() {
    add("<section id=\"tasks\"><h2>Tasks</h2>\n");
    add(
        "<p class=\"lead\">Questions of which the first answer was accepted, or one after repair."
            + " A verdict is a correction after failed scenarios.</p>\n");
    add("<div class=\"scroll\"><table>\n<thead><tr><th>Model</th><th>Task</th>");
    add("<th>First answer</th><th>With repair</th><th>Answers</th></tr></thead>\n<tbody>\n");
    for (EvaluationRow row : rows) {
      for (TaskResult task : row.tasks()) {
        add("<tr><th scope=\"row\">%s%s</th>", row.model(), row.authored() ? " (authored)" : "");
        add("<td>%s</td>", task.task());
        add("<td>%s of %s</td>", task.first(), task.asked());
        add("<td>%s of %s</td>", task.accepted(), task.asked());
        add("<td>%s</td></tr>\n", EvaluationText.answers(task));
      }
    }
    add("</tbody></table></div></section>\n");
  }

  private void classes(Map<String, Integer> classes) {
    if (classes.isEmpty()) {
      add("<td class=\"none\">nothing</td>");
      return;
    }
    add("<td><ul>");
    classes.forEach((name, count) -> add("<li><code>%s</code> %s×</li>", name, count));
    add("</ul></td>");
  }

  private void allRuns() {
    add("<section id=\"runs\"><h2>All runs</h2>\n<div class=\"scroll\"><table>\n<thead><tr>");
    add("<th>Run</th>");
    TITLES.forEach(title -> add("<th>%s</th>", title));
    add(
        "<th>Failed by</th><th>Components for</th><th"
            + " class=\"number\">Seconds</th></tr></thead>\n");
    add("<tbody>\n");
    runs.forEach(this::run);
    add("</tbody></table></div></section>\n");
  }

  private void run(EvaluatedRun run) {
    String name = run.model() + " " + run.number();
    if (!run.isCounted()) {
      add("<tr><th scope=\"row\">%s</th>", name);
      add("<td colspan=\"6\" class=\"none\">not counted: %s</td></tr>\n", run.reason());
      return;
    }
    String page = EvaluationFolder.nameOf(run.model(), run.number()) + "/" + ReportPage.FILE;
    add("<tr><th scope=\"row\"><a href=\"%s\">%s</a>", page, name);
    Optional.of(run.answeredBy())
        .filter(models -> !models.equals(List.of(run.model())))
        .ifPresent(
            models -> add("<div class=\"muted small\">as %s</div>", String.join(", ", models)));
    add("</th>");
    EvaluationRow.ARTEFACTS.values().forEach(artefact -> grade(artefact.apply(run)));
    add("<td>%s</td>", String.join(", ", run.failures()));
    add("<td class=\"muted\">%s</td>", run.implementedFor());
    add(
        "<td class=\"number\">%s</td></tr>\n",
        String.format(Locale.ROOT, "%.1f", run.host().seconds()));
  }

  private void grade(Score score) {
    boolean repaired = score.first() != score.last();
    String word = EvaluationText.word(score.last()) + (repaired ? ", after repair" : "");
    String tone =
        score.last() == Grade.PASSED ? "good" : score.last() == Grade.FAILED ? "bad" : "muted";
    add("<td class=\"%s\">%s</td>", tone, word);
  }

  private void add(String html, Object... texts) {
    page.add(html, texts);
  }
}
