package dev.eventchain.pipeline.requirements;

import com.fasterxml.jackson.annotation.JsonInclude;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.documents.JsonLayout;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.output.OutputFolder;
import dev.eventchain.pipeline.engine.StandingVerdict;
import dev.eventchain.pipeline.files.TextTable;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.results.RequirementOutcome;
import dev.eventchain.pipeline.results.RequirementOutcome.Outcome;
import dev.eventchain.pipeline.results.ResultJson;
import dev.eventchain.pipeline.run.Progress;
import dev.eventchain.pipeline.run.RunOptions;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.project.AcceptedTexts;
import dev.eventchain.project.Requirements;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The requirements of a project, with their sources, what satisfies and tests them, and the verdict
 * of the last run where it is about the current files.
 *
 * @param rows in the order of the sources
 * @param diagnostics the findings about the sources, none of them an error
 */
public record RequirementTable(List<Row> rows, List<Diagnostic> diagnostics) {

  /**
   * A requirement.
   *
   * @param source its file and line
   * @param verdict {@code proved}, {@code violated} or {@code not tested}
   * @param reason why it is not tested, if that is known
   */
  public record Row(
      String id,
      String text,
      String source,
      Optional<String> type,
      Optional<String> status,
      @JsonInclude(JsonInclude.Include.NON_EMPTY) List<String> tags,
      @JsonInclude(JsonInclude.Include.NON_EMPTY) List<String> parents,
      List<String> components,
      List<String> scenarios,
      String verdict,
      Optional<String> reason) {}

  /** Copies the lists. */
  public RequirementTable {
    rows = List.copyOf(rows);
    diagnostics = List.copyOf(diagnostics);
  }

  /**
   * Reads a project and its results. Nothing is run or written.
   *
   * @param output the folder of the project's results
   * @throws dev.eventchain.diagnostics.DiagnosticException INPUT if something cannot be read
   */
  public static RequirementTable of(Project project, Path output, Suppressions suppressions) {
    RunContext run = reading(project, output, suppressions);
    Requirements requirements = run.requirements();
    RequirementUses uses = RequirementUses.of(run);
    StandingVerdict verdict = StandingVerdict.of(run);
    List<Row> rows = new ArrayList<>();
    for (WrittenRequirement item : requirements.items()) {
      rows.add(row(item, project.placeOf(item.location()), uses, verdict));
    }
    return new RequirementTable(rows, requirements.diagnostics());
  }

  /** Returns a run that reads files. */
  static RunContext reading(Project project, Path output, Suppressions suppressions) {
    RunOptions usual = RunOptions.of(output).in(output, Stage.SIMULATE, Stage.SIMULATE);
    return new RunContext(
        project,
        usual.accepting(suppressions),
        OutputFolder.inMemory(new HashMap<>()),
        Progress.NONE,
        Optional.empty());
  }

  private static Row row(
      WrittenRequirement item, String source, RequirementUses uses, StandingVerdict verdict) {
    Optional<String> reason = untested(item, verdict);
    Outcome outcome =
        reason.isPresent()
            ? Outcome.NOT_TESTED
            : verdict.of(item.id()).map(RequirementOutcome::outcome).orElse(Outcome.NOT_TESTED);
    return new Row(
        item.id(),
        item.text(),
        source,
        item.details().type(),
        item.details().status(),
        item.details().tags(),
        item.parentIds(),
        uses.components(item.id()),
        uses.scenarios(item.id()),
        outcome.words(),
        reason);
  }

  /** Returns why the verdict says nothing about a requirement; empty if it does. */
  private static Optional<String> untested(WrittenRequirement item, StandingVerdict verdict) {
    if (verdict.problem().isPresent()) {
      return verdict.problem();
    }
    Optional<RequirementOutcome> outcome = verdict.of(item.id());
    if (outcome.isEmpty()) {
      return Optional.of("the last run did not know it");
    }
    boolean same = outcome.get().text().equals(AcceptedTexts.fingerprint(item.text()));
    return same ? Optional.empty() : Optional.of("its text has changed since the last run");
  }

  /** Returns the table for people. */
  public String text() {
    List<List<String>> cells = new ArrayList<>();
    cells.add(List.of("requirement", "source", "parents", "components", "scenarios", "verdict"));
    for (Row row : rows) {
      cells.add(
          List.of(
              row.id(),
              row.source(),
              listed(row.parents()),
              listed(row.components()),
              listed(row.scenarios()),
              row.verdict()));
    }
    return TextTable.of(cells) + reasons();
  }

  /** Returns a line for each reason why requirements are not tested, with their ids. */
  private String reasons() {
    Map<String, List<String>> ids = new LinkedHashMap<>();
    for (Row row : rows) {
      row.reason().ifPresent(it -> ids.computeIfAbsent(it, key -> new ArrayList<>()).add(row.id()));
    }
    StringBuilder text = new StringBuilder();
    ids.forEach(
        (reason, all) -> {
          String which = all.size() == rows.size() ? "" : " " + String.join(", ", all);
          text.append("not tested").append(which).append(": ").append(reason).append('\n');
        });
    return text.toString();
  }

  private static String listed(List<String> names) {
    return names.isEmpty() ? "-" : String.join(", ", names);
  }

  /** Returns the table as JSON. */
  public String json() {
    return JsonLayout.of(ResultJson.tree(new Json(rows))) + "\n";
  }

  private record Json(List<Row> requirements) {}
}
