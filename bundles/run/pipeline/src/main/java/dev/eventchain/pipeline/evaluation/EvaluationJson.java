package dev.eventchain.pipeline.evaluation;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.ResourceText;
import dev.eventchain.documents.JsonLayout;
import dev.eventchain.pipeline.evaluation.EvaluatedRun.Score;
import dev.eventchain.pipeline.evaluation.EvaluatedRun.Usage;
import dev.eventchain.pipeline.evaluation.EvaluationRow.Rate;
import dev.eventchain.pipeline.project.Configuration;
import dev.eventchain.pipeline.project.Project;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** The results of an evaluation as JSON, {@code evaluation.json}. */
final class EvaluationJson {

  private static final double DECIMALS = 10_000;

  private EvaluationJson() {}

  static String of(
      Project project,
      EvaluationOptions options,
      List<EvaluationRow> rows,
      List<EvaluatedRun> runs) {
    Configuration configuration = project.configuration();
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    json.put("format", "eventchain-evaluation/1");
    String label = EvaluationText.label(rows);
    if (!label.isEmpty()) {
      json.put("label", label);
    }
    json.put("project", configuration.name());
    json.put("title", configuration.title());
    json.put("source", options.kindOfSource(project));
    json.put("runsOfEachModel", options.runs());
    ArrayNode models = json.putArray("models");
    rows.forEach(row -> model(models.addObject(), row, configuration));
    ArrayNode all = json.putArray("runs");
    runs.forEach(run -> run(all.addObject(), run));
    return JsonLayout.of(json) + "\n";
  }

  private static void model(ObjectNode json, EvaluationRow row, Configuration configuration) {
    json.put("model", row.model());
    json.put("measuresALanguageModel", !row.authored() && !row.counted().isEmpty());
    json.put("authored", row.authored());
    json.put("counted", row.counted().size());
    ObjectNode uncounted = json.putObject("uncounted");
    row.reasons().forEach((state, count) -> uncounted.put(name(state), count));
    if (row.counted().isEmpty()) {
      return;
    }
    EvaluationRow.ARTEFACTS.forEach(
        (name, artefact) -> {
          ObjectNode rates = json.putObject(name);
          rate(rates.putObject("withoutRepair"), row.rate(artefact, false));
          rate(rates.putObject("withRepair"), row.rate(artefact, true));
        });
    usage(json, row.usage());
    row.cost(configuration).ifPresent(cost -> json.put("cost", cost));
    tasks(json.putObject("tasks"), row.tasks());
    repairs(json.putObject("repairs"), row.repairs());
    classes(json.putObject("failures"), row.classes(EvaluatedRun::failures));
    json.putObject("host").put("seconds", rounded(row.seconds()));
  }

  private static void rate(ObjectNode json, Rate rate) {
    json.put("passed", rate.passed());
    json.put("judged", rate.of());
    rate.interval()
        .ifPresent(
            interval ->
                json.putArray("interval95")
                    .add(rounded(interval.low()))
                    .add(rounded(interval.high())));
  }

  private static void usage(ObjectNode json, Usage usage) {
    json.putObject("tokens")
        .put("answers", usage.calls())
        .put("answersWithoutNumber", usage.unknown())
        .put("input", usage.inputTokens())
        .put("output", usage.outputTokens());
  }

  private static void tasks(ObjectNode json, List<TaskResult> tasks) {
    for (TaskResult task : tasks) {
      ObjectNode node = json.putObject(task.task());
      node.put("asked", task.asked());
      node.put("withoutRepair", task.first());
      node.put("withRepair", task.accepted());
      node.put("bytes", task.bytes());
      usage(node, task.usage());
    }
  }

  private static void repairs(ObjectNode json, List<RepairResult> repairs) {
    for (RepairResult repair : repairs) {
      json.putObject(repair.error())
          .put("sentBack", repair.sentBack())
          .put("right", repair.right());
    }
  }

  private static void classes(ObjectNode json, Map<String, Integer> classes) {
    classes.forEach(json::put);
  }

  private static void run(ObjectNode json, EvaluatedRun run) {
    json.put("model", run.model());
    json.put("run", run.number());
    json.put("state", name(run.state()));
    if (!run.isCounted()) {
      json.put("reason", run.reason());
      return;
    }
    json.put("folder", EvaluationFolder.nameOf(run.model(), run.number()));
    EvaluationRow.ARTEFACTS.forEach(
        (name, artefact) -> score(json.putObject(name), artefact.apply(run)));
    json.put("implementedFor", run.implementedFor());
    json.put("authored", run.authored());
    run.answeredBy().forEach(json.putArray("answeredBy")::add);
    usage(json, run.usage());
    tasks(json.putObject("tasks"), run.tasks());
    repairs(json.putObject("repairs"), run.repairs());
    run.failures().forEach(json.putArray("failures")::add);
    json.putObject("host").put("seconds", rounded(run.host().seconds()));
  }

  private static void score(ObjectNode json, Score score) {
    json.put("withoutRepair", name(score.first()));
    json.put("withRepair", name(score.last()));
  }

  private static String name(Enum<?> value) {
    return value.name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  private static double rounded(double value) {
    return Math.round(value * DECIMALS) / DECIMALS;
  }

  /** Returns the JSON Schema of the file. */
  static String schema() {
    return ResourceText.of(EvaluationJson.class, "evaluation.schema.json");
  }
}
