package dev.eventchain.pipeline.evaluation;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException.Reason;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.pipeline.evaluation.EvaluatedRun.Grade;
import dev.eventchain.pipeline.evaluation.EvaluatedRun.State;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.run.Stage;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** The result of all runs of an evaluation, in all its formats. */
final class EvaluationResult {

  private final Project project;
  private final EvaluationOptions options;
  private final EvaluationFolder folder;
  private final List<EvaluatedRun> runs;
  private final List<Diagnostic> whyUncounted;
  private final List<EvaluationRow> rows;

  EvaluationResult(
      Project project,
      EvaluationOptions options,
      EvaluationFolder folder,
      List<EvaluationRun.Done> done) {
    this.project = project;
    this.options = options;
    this.folder = folder;
    this.runs = done.stream().map(EvaluationRun.Done::run).toList();
    this.whyUncounted =
        List.copyOf(
            new LinkedHashSet<>(done.stream().flatMap(each -> each.findings().stream()).toList()));
    this.rows =
        options.models().stream()
            .flatMap(model -> EvaluationRow.of(model, runsOf(model)).stream())
            .toList();
  }

  private List<EvaluatedRun> runsOf(String model) {
    return runs.stream().filter(run -> run.model().equals(model)).toList();
  }

  EvaluationOutcome write() {
    folder.write(EvaluationFolder.JSON, EvaluationJson.of(project, options, rows, runs));
    folder.write(EvaluationFolder.PAGE, EvaluationPage.of(project, options, rows, runs));
    return new EvaluationOutcome(
        EvaluationText.of(project.configuration(), rows),
        findings(),
        failure(),
        List.of(folder.path(EvaluationFolder.PAGE)));
  }

  private boolean anyCounted() {
    return runs.stream().anyMatch(EvaluatedRun::isCounted);
  }

  private boolean any(State state) {
    return runs.stream().anyMatch(run -> run.state() == state);
  }

  private Optional<Reason> failure() {
    if (any(State.UNREACHABLE) || any(State.NOT_BEGUN)) {
      return Optional.of(Reason.UNAVAILABLE);
    }
    if (any(State.WAITING)) {
      return Optional.of(Reason.WAITING);
    }
    return anyCounted() ? Optional.empty() : Optional.of(Reason.FINDINGS);
  }

  private List<Diagnostic> findings() {
    List<Diagnostic> found = new ArrayList<>();
    rows.stream().filter(EvaluationRow::authored).map(this::authored).forEach(found::add);
    rows.stream()
        .filter(row -> !row.uncounted().isEmpty())
        .map(this::uncounted)
        .forEach(found::add);
    long unjudged = runs.stream().filter(EvaluationResult::hasNoChain).count();
    if (unjudged > 0) {
      found.add(noReference(unjudged));
    }
    found.addAll(whyUncounted);
    if (failure().equals(Optional.of(Reason.FINDINGS))) {
      found.add(
          finding(
              Diagnostic.of(
                  EvaluationRules.NOTHING_COUNTED,
                  "No run counts, so nothing can be said about any model.",
                  place()),
              "Let the models answer: --llm live, or handoff:FOLDER."));
    }
    return found;
  }

  private SourceLocation place() {
    return SourceLocation.of(project.configurationFile());
  }

  private static Diagnostic finding(Diagnostic finding, String hint) {
    return finding.withHint(hint);
  }

  private Diagnostic authored(EvaluationRow row) {
    return finding(
        Diagnostic.of(
            EvaluationRules.AUTHORED,
            "The answers of '%s' are %s.".formatted(row.model(), EvaluationText.LABEL),
            place()),
        "They only show what an evaluation looks like. Let a language model answer: --llm live.");
  }

  private Diagnostic uncounted(EvaluationRow row) {
    return finding(
        Diagnostic.of(
            EvaluationRules.RUN_UNCOUNTED,
            "Of '%s', %s.".formatted(row.model(), EvaluationText.counted(row)),
            place()),
        "Run the same command again once their answers are available.");
  }

  /** Returns whether the code could not be judged because there was no chain. */
  private static boolean hasNoChain(EvaluatedRun run) {
    return run.isCounted()
        && run.functionCode().last() == Grade.UNKNOWN
        && run.failures().stream().anyMatch(each -> each.startsWith(Stage.DESIGN.id() + ":"));
  }

  private Diagnostic noReference(long runs) {
    return finding(
        Diagnostic.of(
            EvaluationRules.REFERENCE_MISSING,
            String.format(
                Locale.ROOT,
                "In %d runs no code was judged: no chain was designed, and the project has none.",
                runs),
            place()),
        "Write a chain to model/chain.xmi by hand, or run the project first.");
  }
}
