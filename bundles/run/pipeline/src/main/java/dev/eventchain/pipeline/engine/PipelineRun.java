package dev.eventchain.pipeline.engine;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.FileReads;
import dev.eventchain.diagnostics.FileReads.Recorded;
import dev.eventchain.diagnostics.Suppressions.Parted;
import dev.eventchain.output.OutputFolder;
import dev.eventchain.output.OutputFolder.OnEdit;
import dev.eventchain.pipeline.design.ConstrainStage;
import dev.eventchain.pipeline.design.DesignStage;
import dev.eventchain.pipeline.design.ImplementStage;
import dev.eventchain.pipeline.design.ModelStage;
import dev.eventchain.pipeline.design.VerdictCorrection;
import dev.eventchain.pipeline.generate.GenerateStage;
import dev.eventchain.pipeline.generate.ValidateStage;
import dev.eventchain.pipeline.project.Project;
import dev.eventchain.pipeline.report.EarlierRun;
import dev.eventchain.pipeline.run.Progress;
import dev.eventchain.pipeline.run.Progress.Status;
import dev.eventchain.pipeline.run.RunOptions;
import dev.eventchain.pipeline.run.RunResult;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.simulate.SimulateStage;
import dev.eventchain.pipeline.stage.Correction;
import dev.eventchain.pipeline.stage.Fingerprint;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.pipeline.stage.Sample;
import dev.eventchain.pipeline.stage.SimulationInputs;
import dev.eventchain.pipeline.stage.StageMemory;
import dev.eventchain.pipeline.stage.StageOutcome;
import dev.eventchain.pipeline.stage.StageRecord;
import dev.eventchain.pipeline.stage.StageResult;
import dev.eventchain.pipeline.stage.StageWork;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** Runs the requested stages in order, as far as possible. */
public final class PipelineRun {

  static final Map<Stage, StageWork> WORK =
      new EnumMap<>(
          Map.of(
              Stage.DESIGN, new DesignStage(),
              Stage.IMPLEMENT, new ImplementStage(),
              Stage.MODEL, new ModelStage(),
              Stage.CONSTRAIN, new ConstrainStage(),
              Stage.VALIDATE, new ValidateStage(),
              Stage.GENERATE, new GenerateStage(),
              Stage.SIMULATE, new SimulateStage()));

  /** Stages that ask language models. */
  private static final Set<Stage> ASKING =
      Set.of(Stage.DESIGN, Stage.IMPLEMENT, Stage.MODEL, Stage.CONSTRAIN);

  private final RunContext run;
  private final StageMemory memory;
  private final Progress progress;
  private final EarlierRun before;
  private final StandingResults standing;
  private final StandingFailure failures;
  private final Map<Stage, StageOutcome> outcomes = new EnumMap<>(Stage.class);

  /** The finding that the standing verdict is not PASSED, in a run for a report alone. */
  private final Optional<Diagnostic> notPassed;

  private Optional<DiagnosticException.Reason> failure = Optional.empty();

  /**
   * The result of a run and the outcomes of its stages.
   *
   * @param outcomes the outcomes, in the order of the stages
   */
  public record Ended(RunResult result, Map<Stage, StageOutcome> outcomes) {}

  private PipelineRun(RunContext run, StageMemory memory, EarlierRun before) {
    this.run = run;
    this.memory = memory;
    this.progress = run.progress();
    this.before = before;
    this.standing = new StandingResults(run, memory);
    this.failures = new StandingFailure(run);
    this.notPassed = run.options().onlyReports() ? LastVerdict.notPassed(run) : Optional.empty();
  }

  /**
   * Runs stages of a project.
   *
   * @param sample the sample, if this is the run of an evaluation
   * @return the end of the run, also if a stage could not continue
   * @throws DiagnosticException INPUT if the output folder cannot be written or is in use
   */
  public static Ended run(
      Project project, RunOptions options, Progress progress, Optional<Sample> sample) {
    EarlierRun before = EarlierRun.read(options.compare());
    try (OutputFolder output = outputFor(options)) {
      RunContext context = new RunContext(project, options, output, progress, sample);
      StageMemory memory = new StageMemory(output, options.output());
      if (!options.readsOnly()) {
        boolean restored = !output.hasRecords() && memory.restoreRecords();
        context.findLostRecords(restored);
      }
      context.write(RunContext.IGNORE, new byte[0]);
      PipelineRun run = new PipelineRun(context, memory, before);
      return new Ended(run.runStages(), run.outcomes);
    }
  }

  /** Opens the output folder; a run that only validates writes nothing to it. */
  private static OutputFolder outputFor(RunOptions options) {
    return options.readsOnly()
        ? OutputFolder.inMemory(new HashMap<>())
        : OutputFolder.open(options.output());
  }

  private RunResult runStages() {
    for (Stage stage : Stage.values()) {
      if (stage == Stage.REPORT) {
        break;
      }
      boolean possible = failure.isEmpty() || asksMeanwhile(stage) || isTriedAnyway(stage);
      end(takesPart(stage) && possible ? runGuarded(stage) : StageEnds.notRun(stage));
    }
    correctByVerdict();
    boolean judged = outcomes.get(Stage.SIMULATE).report().isPresent();
    boolean stays = notPassed.isPresent();
    if (failure.isPresent() && (!judged || run.options().isPartial()) && !stays) {
      standing.withdraw(stoppedIn());
    }
    boolean simulates = run.options().runs(Stage.SIMULATE);
    if (failure.isEmpty() && !simulates && !run.options().readsOnly()) {
      restoreVerdict();
    }
    RunResult result =
        new Conclusion(run, outcomes, failure, progress, before, stays)
            .conclude()
            .withRecordings(run.recordings());
    if (result.report().isEmpty()) {
      standing.putReportBack();
    }
    return result;
  }

  /**
   * Returns whether a stage runs, or its result is recalled for a report alone. If there was no
   * verdict, no result is recalled: the report of that run stays.
   */
  private boolean takesPart(Stage stage) {
    return run.options().onlyReports()
        ? notPassed.isEmpty() || stage == Stage.SIMULATE
        : run.options().runs(stage);
  }

  private void end(StageOutcome outcome) {
    outcomes.put(outcome.stage(), outcome);
    progress.ended(outcome.stage(), outcome.status(), outcome.duration(), outcome.details());
  }

  /** Reruns the stages on which a correction depends, as long as a failed verdict brings one. */
  private void correctByVerdict() {
    int rounds = run.project().configuration().repairs();
    while (rounds-- > 0 && mayBeCorrected()) {
      long start = System.nanoTime();
      Optional<Correction> corrected;
      try {
        corrected = new VerdictCorrection(run).ask();
      } catch (DiagnosticException e) {
        failure = Optional.of(e.reason());
        failures.keep(e.reason());
        end(StageEnds.stopped(Stage.IMPLEMENT, e, run.takeFindings(), start));
        return;
      }
      if (corrected.isEmpty()) {
        return;
      }
      run.models().correct(corrected.get());
      if (!corrected.get().isEmpty()) {
        rerun(corrected.get().stages());
      }
    }
  }

  private void rerun(List<Stage> stages) {
    failure = Optional.empty();
    for (Stage stage : stages) {
      boolean possible = failure.isEmpty() && takesPart(stage);
      end(possible ? runGuarded(stage) : StageEnds.notRun(stage));
    }
  }

  private boolean mayBeCorrected() {
    return failure.equals(Optional.of(DiagnosticException.Reason.FINDINGS))
        && outcomes.get(Stage.SIMULATE).report().isPresent()
        && VerdictCorrection.isAllowed(run);
  }

  /** Returns whether a stage needs none of the missing answers, so that it can ask meanwhile. */
  private boolean asksMeanwhile(Stage stage) {
    return failure.equals(Optional.of(DiagnosticException.Reason.WAITING))
        && (stage == Stage.MODEL || stage == Stage.CONSTRAIN)
        && !outcomes.get(Stage.DESIGN).status().isStopped();
  }

  /** Returns whether a stage of an evaluation is judged separately and has all of its inputs. */
  private boolean isTriedAnyway(Stage stage) {
    DiagnosticException.Reason reason = failure.orElseThrow();
    boolean judged =
        reason == DiagnosticException.Reason.FINDINGS
            || reason == DiagnosticException.Reason.WAITING;
    return run.models().isEvaluated() && judged && NeededStages.areDone(stage, outcomes);
  }

  /** Restores the earlier verdict if a simulation would be up to date. */
  private void restoreVerdict() {
    try {
      new EarlierStages(run, memory, WORK).require(Stage.SIMULATE);
      standing.recall(fingerprint(Stage.SIMULATE));
    } catch (DiagnosticException e) {
      // It concerns other files than the current ones. The next simulation reports which.
      return;
    }
  }

  private Fingerprint fingerprint(Stage stage) {
    Fingerprint fingerprint = new Fingerprint(run).add(stage.id());
    WORK.get(stage).fingerprint(run, fingerprint);
    return fingerprint;
  }

  private Stage stoppedIn() {
    return StageEnds.firstStopped(outcomes.values());
  }

  /** Runs a stage; withdraws an earlier verdict however the stage fails. */
  private StageOutcome runGuarded(Stage stage) {
    boolean ended = false;
    try {
      StageOutcome outcome = runStage(stage);
      ended = true;
      return outcome;
    } finally {
      if (!ended) {
        standing.withdraw(stage);
      }
    }
  }

  private StageOutcome runStage(Stage stage) {
    progress.started(stage);
    long start = System.nanoTime();
    try {
      if (stage == Stage.SIMULATE && notPassed.isPresent()) {
        throw new DiagnosticException(DiagnosticException.Reason.FINDINGS, notPassed.get());
      }
      if (stage == run.options().stages().first()) {
        new EarlierStages(run, memory, WORK).require(stage).forEach(run::find);
        checkScenarios();
      }
      Fingerprint fingerprint = fingerprint(stage);
      Optional<StageRecord> remembered =
          mayBeSkipped(stage) ? recall(stage, fingerprint) : Optional.empty();
      if (remembered.isPresent()) {
        return unchanged(stage, remembered.get(), start);
      }
      return run.options().onlyReports() && stage != Stage.VALIDATE
          ? unrecalled(stage)
          : executed(stage, fingerprint, start);
    } catch (DiagnosticException e) {
      failure = Optional.of(e.reason());
      return StageEnds.stopped(stage, e, run.takeFindings(), start);
    }
  }

  /** Returns the outcome of a stage whose result does not stand, in a run for a report alone. */
  private StageOutcome unrecalled(Stage stage) {
    if (stage == Stage.SIMULATE) {
      new EarlierStages(run, memory, WORK).require(stage).forEach(run::find);
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, LastVerdict.outdated(run));
    }
    return StageEnds.notRun(stage);
  }

  /**
   * Ends a run early if its scenarios cannot lead to a verdict. A mere validation finds that
   * together with all else.
   */
  private void checkScenarios() {
    boolean validates =
        run.options().stages().last() == Stage.VALIDATE && !run.options().readsOnly();
    if (run.options().runs(Stage.SIMULATE) || validates) {
      List<Diagnostic> found = SimulationInputs.check(run);
      if (run.anyErrorCounts(found)) {
        throw new DiagnosticException(DiagnosticException.Reason.FINDINGS, found);
      }
      found.forEach(run::find);
    }
  }

  private boolean mayBeSkipped(Stage stage) {
    if (run.options().onlyReports()) {
      return WORK.get(stage).skippable();
    }
    boolean anyway = stage == Stage.SIMULATE && run.options().simulation().simulatesAnyway();
    boolean corrected = run.models().correction().concerns(stage);
    boolean asked = run.options().stages().again() || anyway || isPartial(stage) || corrected;
    return WORK.get(stage).skippable() && !asked;
  }

  /** Returns whether a stage simulates only some scenarios and therefore writes no results. */
  private boolean isPartial(Stage stage) {
    return stage == Stage.SIMULATE && run.options().isPartial();
  }

  /** Returns the record of an up-to-date stage, unless edited files are to be overwritten. */
  private Optional<StageRecord> recall(Stage stage, Fingerprint inputs) {
    if (stage == Stage.SIMULATE) {
      return standing.recall(inputs).or(() -> failures.recall(inputs));
    }
    return memory
        .recall(stage, inputs)
        .filter(record -> !run.anyErrorCounts(record.diagnostics()))
        .filter(
            record ->
                run.options().onEdit() == OnEdit.KEEP
                    || record.outputs().keySet().stream().noneMatch(run.output()::isEdited));
  }

  private StageOutcome executed(Stage stage, Fingerprint inputs, long start) {
    StageWork work = WORK.get(stage);
    if (work.skippable()) {
      announce(stage, inputs);
    }
    // Findings from before the stage's work concern this run only and are not recorded.
    List<Diagnostic> all = new ArrayList<>(run.takeFindings());
    Recorded<StageResult> done = FileReads.record(() -> work.execute(run));
    StageResult result = done.value();
    List<Diagnostic> found = new ArrayList<>(run.takeFindings());
    found.addAll(result.diagnostics());
    all.addAll(found);
    Parted parted = run.options().suppressions().part(all);
    boolean failed = Diagnostic.anyError(parted.remaining());
    if (failed) {
      failure = Optional.of(DiagnosticException.Reason.FINDINGS);
      if (stage == Stage.SIMULATE) {
        failures.ended(StageRecord.of(inputs.value(), inputs, done, run.output(), found));
      }
    } else if (work.skippable() && !isPartial(stage)) {
      // An error that is suppressed now may count later, so the stage runs again. One that asks
      // language models is skipped until then, so that nobody is asked again.
      boolean again = Diagnostic.anyError(found) && !ASKING.contains(stage);
      String key = again ? StageRecord.NEVER : inputs.value();
      memory.remember(stage, StageRecord.of(key, inputs, done, run.output(), found));
    }
    return StageEnds.ended(stage, failed ? Status.FAILED : Status.DONE, start, result, parted);
  }

  /** Withdraws the results and forgets the stage before it runs: its files may change. */
  private void announce(Stage stage, Fingerprint inputs) {
    boolean resultsStay = isPartial(stage) && standing.recall(inputs).isPresent();
    if (!resultsStay) {
      standing.withdraw(stage);
    }
    if (!isPartial(stage)) {
      memory.forget(stage);
    }
  }

  /** Returns the outcome of a skipped stage; edited outputs are reported and checked again. */
  private StageOutcome unchanged(Stage stage, StageRecord record, long start) {
    run.models().recall(stage, record.report());
    StageResult result = EditedOutputs.check(run, WORK.get(stage), record);
    List<Diagnostic> found = new ArrayList<>(run.takeFindings());
    result.diagnostics().stream().filter(each -> !found.contains(each)).forEach(found::add);
    Parted parted = run.options().suppressions().part(found);
    if (Diagnostic.anyError(parted.remaining())) {
      failure = Optional.of(DiagnosticException.Reason.FINDINGS);
      return StageEnds.ended(stage, Status.FAILED, start, result, parted);
    }
    return StageEnds.ended(stage, Status.UNCHANGED, start, result, parted);
  }
}
