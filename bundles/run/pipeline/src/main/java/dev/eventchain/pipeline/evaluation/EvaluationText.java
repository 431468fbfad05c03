package dev.eventchain.pipeline.evaluation;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Printable;
import dev.eventchain.pipeline.evaluation.EvaluatedRun.Grade;
import dev.eventchain.pipeline.evaluation.EvaluatedRun.Usage;
import dev.eventchain.pipeline.evaluation.EvaluationRow.Rate;
import dev.eventchain.pipeline.project.Configuration;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;

/** The table of an evaluation for a terminal. */
final class EvaluationText {

  /** Label of results with answers that people wrote. */
  static final String LABEL = "authored by people: not an evaluation of a language model";

  private final Configuration configuration;
  private final StringBuilder out = new StringBuilder();

  private EvaluationText(Configuration configuration) {
    this.configuration = configuration;
  }

  /** Returns the text; without a table if no run counts. */
  static String of(Configuration configuration, List<EvaluationRow> rows) {
    EvaluationText text = new EvaluationText(configuration);
    String label = label(rows);
    text.out.append(label.isEmpty() ? "" : label + "\n\n");
    if (rows.stream().anyMatch(row -> !row.counted().isEmpty())) {
      text.line("", "chain model", "function code", "overall");
    }
    rows.forEach(text::add);
    return text.out.toString();
  }

  /** Returns the label on top of every format of the report; empty if none is needed. */
  static String label(List<EvaluationRow> rows) {
    List<EvaluationRow> authored = rows.stream().filter(EvaluationRow::authored).toList();
    if (authored.isEmpty()) {
      return "";
    }
    boolean all = rows.stream().allMatch(row -> row.authored() || row.counted().isEmpty());
    String models = authored.stream().map(EvaluationRow::model).collect(Collectors.joining(", "));
    return (all ? "The answers" : "Answers of " + Printable.line(models)) + " are " + LABEL + ".";
  }

  private void add(EvaluationRow row) {
    out.append(Printable.line(row.model())).append(row.authored() ? " (authored)" : "");
    out.append(": ").append(String.join("; ", facts(row, configuration))).append('\n');
    if (row.counted().isEmpty()) {
      return;
    }
    for (boolean repaired : new boolean[] {false, true}) {
      List<String> cells =
          EvaluationRow.ARTEFACTS.values().stream()
              .map(artefact -> cell(row.rate(artefact, repaired)))
              .toList();
      String name = repaired ? "with repair" : "without repair";
      line(name, cells.get(0), cells.get(1), cells.get(2));
    }
    tasks(row.tasks());
    repairs(row.repairs());
    classes("failed by", row.classes(EvaluatedRun::failures));
  }

  /** Returns the number of counted runs of a row, their cost and their duration. */
  static List<String> facts(EvaluationRow row, Configuration configuration) {
    return List.of(counted(row), cost(row, configuration), seconds(row)).stream()
        .filter(fact -> !fact.isEmpty())
        .toList();
  }

  /** Returns the number of counted runs, and the reasons why the others do not count. */
  static String counted(EvaluationRow row) {
    int all = row.counted().size() + row.uncounted().size();
    String others =
        row.reasons().entrySet().stream()
            .map(entry -> entry.getKey().words() + ": " + entry.getValue())
            .collect(Collectors.joining(", "));
    return row.counted().size()
        + " of "
        + Coverage.counted(all, "run")
        + " counted"
        + (others.isEmpty() ? "" : " (" + others + ")");
  }

  private static String cost(EvaluationRow row, Configuration configuration) {
    Usage usage = row.usage();
    if (usage.calls() == 0) {
      return "";
    }
    String tokens =
        usage.unknown() == usage.calls()
            ? "tokens unknown"
            : String.format(Locale.ROOT, "%,d tokens", usage.inputTokens() + usage.outputTokens())
                + (usage.unknown() == 0 ? "" : ", those of some answers unknown");
    return tokens
        + row.cost(configuration).map(cost -> ", cost " + cost.toPlainString()).orElse("");
  }

  private static String seconds(EvaluationRow row) {
    return row.counted().isEmpty() ? "" : String.format(Locale.ROOT, "%.1f s", row.seconds());
  }

  /** Returns a rate with its interval. */
  static String cell(Rate rate) {
    return rate.interval()
        .map(
            interval ->
                String.format(
                    Locale.ROOT,
                    "%d/%d  %.0f\u2013%.0f %%",
                    rate.passed(),
                    rate.of(),
                    interval.low() * 100,
                    interval.high() * 100))
        .orElse("nothing to judge");
  }

  private void tasks(List<TaskResult> tasks) {
    if (!tasks.isEmpty()) {
      line("task", "first answer", "with repair", "answers");
    }
    for (TaskResult task : tasks) {
      line(
          task.task(),
          task.first() + "/" + task.asked(),
          task.accepted() + "/" + task.asked(),
          answers(task));
    }
  }

  /** Returns the number, the size and the tokens of a task's answers. */
  static String answers(TaskResult task) {
    Usage usage = task.usage();
    String tokens =
        usage.unknown() > 0
            ? ""
            : String.format(
                Locale.ROOT, ", %,d tokens", usage.inputTokens() + usage.outputTokens());
    return String.format(Locale.ROOT, "%d, %.1f kB%s", usage.calls(), task.bytes() / 1e3, tokens);
  }

  private void repairs(List<RepairResult> repairs) {
    String text =
        repairs.stream()
            .map(
                it ->
                    String.format(
                        Locale.ROOT, "%s: %d of %d right", it.error(), it.right(), it.sentBack()))
            .collect(Collectors.joining("\n" + " ".repeat(20)));
    if (!text.isEmpty()) {
      line("repairs", text, "", "");
    }
  }

  private void classes(String title, Map<String, Integer> classes) {
    String text =
        classes.entrySet().stream()
            .map(entry -> entry.getKey() + " " + entry.getValue() + "x")
            .collect(Collectors.joining("\n" + " ".repeat(20)));
    if (!text.isEmpty()) {
      line(title, text, "", "");
    }
  }

  private void line(String title, String one, String two, String three) {
    String line = String.format(Locale.ROOT, "  %-17s %-20s %-20s %s\n", title, one, two, three);
    out.append(line.stripTrailing()).append('\n');
  }

  /** Returns a short description of the result of a run. */
  static String words(EvaluatedRun run) {
    return run.isCounted()
        ? "chain model %s, function code %s, overall %s"
            .formatted(
                word(run.chainModel().last()),
                word(run.functionCode().last()),
                word(run.overall().last()))
        : "not counted: " + Printable.line(run.reason());
  }

  /** Returns a grade for people. */
  static String word(Grade grade) {
    return switch (grade) {
      case PASSED -> "passed";
      case FAILED -> "failed";
      case UNKNOWN -> "not judged";
    };
  }
}
