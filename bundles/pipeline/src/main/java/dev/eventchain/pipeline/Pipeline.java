package dev.eventchain.pipeline;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Suppressions.Parted;
import dev.eventchain.m2t.OutputFolder;
import dev.eventchain.pipeline.Progress.Status;
import java.time.Duration;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Runs the stages of a project in order, as far as they are asked for and can go. */
public final class Pipeline {

  private static final Map<Stage, StageWork> WORK =
      new EnumMap<>(
          Map.of(
              Stage.DESIGN, new DesignStage(),
              Stage.IMPLEMENT, new ImplementStage(),
              Stage.MODEL, new ModelStage(),
              Stage.CONSTRAIN, new ConstrainStage(),
              Stage.VALIDATE, new ValidateStage(),
              Stage.GENERATE, new GenerateStage(),
              Stage.SIMULATE, new SimulateStage()));

  private final RunContext run;
  private final StageMemory memory;
  private final Progress progress;
  private final Map<Stage, StageOutcome> outcomes = new EnumMap<>(Stage.class);
  private Optional<DiagnosticException.Reason> failure = Optional.empty();

  private Pipeline(RunContext run, StageMemory memory, Progress progress) {
    this.run = run;
    this.memory = memory;
    this.progress = progress;
  }

  /**
   * Runs stages of a project.
   *
   * @return how the run ended, with everything that was found; also when a stage could not go on
   * @throws DiagnosticException INPUT if the output folder cannot be written or is in use
   */
  public static RunResult run(Project project, RunOptions options, Progress progress) {
    try (OutputFolder output = outputFor(options)) {
      RunContext context = new RunContext(project, options, output, progress);
      StageMemory memory = new StageMemory(output, options.output());
      output.damage().ifPresent(context::find);
      // The generated package is for people to copy, not for a colcon build of the project.
      context.write("COLCON_IGNORE", new byte[0]);
      return new Pipeline(context, memory, progress).runStages();
    }
  }

  /** Validation alone writes nothing, so that it works where nothing can be written. */
  private static OutputFolder outputFor(RunOptions options) {
    boolean readsOnly = options.first() == Stage.VALIDATE && options.last() == Stage.VALIDATE;
    return readsOnly ? OutputFolder.inMemory(new HashMap<>()) : OutputFolder.open(options.output());
  }

  private RunResult runStages() {
    for (Stage stage : Stage.values()) {
      if (stage == Stage.REPORT) {
        break;
      }
      boolean wanted = run.options().runs(stage) && failure.isEmpty();
      StageOutcome outcome = wanted ? runStage(stage) : notRun(stage);
      outcomes.put(stage, outcome);
      progress.ended(stage, outcome.status(), outcome.duration(), outcome.details());
    }
    if (failure.equals(Optional.of(DiagnosticException.Reason.FINDINGS))) {
      withdrawVerdict();
    }
    return new Conclusion(run, outcomes, failure, progress).conclude();
  }

  /**
   * A run that was found wanting before it simulated must not leave an earlier verdict standing.
   */
  private void withdrawVerdict() {
    boolean simulated = outcomes.get(Stage.SIMULATE).report().isPresent();
    if (!simulated && run.options().runs(Stage.SIMULATE) && !run.options().isPartial()) {
      memory.forget(Stage.SIMULATE);
      run.writeResult(
          SimulateStage.VERDICT,
          SimulationReport.noVerdict(run.project().configuration().name(), stoppedIn()));
    }
  }

  private Stage stoppedIn() {
    return outcomes.values().stream()
        .filter(outcome -> outcome.status() == Status.FAILED)
        .map(StageOutcome::stage)
        .findFirst()
        .orElseThrow();
  }

  private StageOutcome runStage(Stage stage) {
    progress.started(stage);
    long start = System.nanoTime();
    StageWork work = WORK.get(stage);
    try {
      Fingerprint fingerprint = new Fingerprint().add(stage.id());
      work.fingerprint(run, fingerprint);
      String key = fingerprint.value();
      Optional<StageRecord> remembered =
          mayBeSkipped(work)
              ? memory.recall(stage, key).filter(r -> isKept(stage, r))
              : Optional.empty();
      return remembered.isPresent()
          ? unchanged(stage, remembered.get(), start)
          : executed(stage, work, key, start);
    } catch (DiagnosticException e) {
      failure = Optional.of(e.reason());
      List<Diagnostic> found = new ArrayList<>(run.takeFindings());
      found.addAll(e.diagnostics());
      // What keeps a stage from its result cannot be suppressed.
      return new StageOutcome(
          stage,
          Status.FAILED,
          since(start),
          reason(e),
          new Parted(found, List.of()),
          Coverage.NONE,
          Optional.empty());
    }
  }

  private boolean mayBeSkipped(StageWork work) {
    return work.skippable() && !run.options().again();
  }

  /** Files that a person edited are written again if they are results, or to be replaced. */
  private boolean isKept(Stage stage, StageRecord record) {
    boolean keepsEdits = stage != Stage.SIMULATE && !run.options().overwrite();
    return keepsEdits || record.outputs().stream().noneMatch(run.output()::isEdited);
  }

  private StageOutcome executed(Stage stage, StageWork work, String key, long start) {
    if (work.skippable()) {
      // Whatever happens from here on, the files are no longer those that are remembered.
      memory.forget(stage);
    }
    StageResult result = work.execute(run);
    List<Diagnostic> found = new ArrayList<>(run.takeFindings());
    found.addAll(result.diagnostics());
    Parted parted = run.options().suppressions().part(found);
    boolean failed = Diagnostic.anyError(parted.remaining());
    if (failed) {
      failure = Optional.of(DiagnosticException.Reason.FINDINGS);
    } else if (mayBeRemembered(stage, work, found)) {
      memory.remember(
          stage,
          new StageRecord(
              key, result.outputs(), result.details(), found, result.coverage(), result.report()));
    }
    return new StageOutcome(
        stage,
        failed ? Status.FAILED : Status.DONE,
        since(start),
        result.details(),
        parted,
        result.coverage(),
        Optional.of(result.report()));
  }

  /** An error that is suppressed today may count tomorrow: then the stage must run again. */
  private boolean mayBeRemembered(Stage stage, StageWork work, List<Diagnostic> found) {
    boolean partial = stage == Stage.SIMULATE && run.options().isPartial();
    return work.skippable() && !partial && !Diagnostic.anyError(found);
  }

  /** A person may have edited what the stage wrote: then that is said again. */
  private StageOutcome unchanged(Stage stage, StageRecord record, long start) {
    List<Diagnostic> found = new ArrayList<>(record.diagnostics());
    for (String name : record.outputs()) {
      run.output().accept(name).filter(edit -> !found.contains(edit)).ifPresent(found::add);
    }
    return new StageOutcome(
        stage,
        Status.UNCHANGED,
        since(start),
        record.details(),
        run.options().suppressions().part(found),
        record.coverage(),
        Optional.of(record.report()));
  }

  /** What an earlier run found out proves nothing about the files of this one. */
  private static StageOutcome notRun(Stage stage) {
    return new StageOutcome(
        stage,
        Status.NOT_RUN,
        Duration.ZERO,
        "",
        new Parted(List.of(), List.of()),
        Coverage.NONE,
        Optional.empty());
  }

  private static String reason(DiagnosticException e) {
    int count = e.diagnostics().size();
    String more = count > 1 ? " (and " + (count - 1) + " more)" : "";
    return e.diagnostics().get(0).message().lines().findFirst().orElse("") + more;
  }

  private static Duration since(long start) {
    return Duration.ofNanos(System.nanoTime() - start);
  }
}
