package dev.eventchain.pipeline.engine;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.output.OutputFolder;
import dev.eventchain.pipeline.design.VerdictCorrection;
import dev.eventchain.pipeline.results.ResultJson;
import dev.eventchain.pipeline.run.SimulationOptions;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.stage.FailedVerdict;
import dev.eventchain.pipeline.stage.Fingerprint;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.pipeline.stage.StageRecord;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import java.io.IOException;
import java.nio.file.Files;
import java.util.Optional;

/**
 * The failed simulation of a run that waits for a person who corrects what failed: the next command
 * goes on from it, as long as its inputs, the suppressions in force and its results are the same.
 * It is a record of its own, which nothing else reads, so that it can never pass for a result.
 */
final class StandingFailure {

  private static final String FILE = ".stages/failure.json";

  private final RunContext run;
  private Optional<StageRecord> last = Optional.empty();

  /**
   * Content of the file.
   *
   * @param record the record of the stage
   * @param suppressions those in force, on which its results depend, too
   * @param verdict what language models are told about it
   */
  record Kept(StageRecord record, String suppressions, FailedVerdict verdict) {}

  StandingFailure(RunContext run) {
    this.run = run;
  }

  /** Receives the record of a simulation that has failed. */
  void ended(StageRecord record) {
    last = Optional.of(record);
  }

  /** Keeps the last failure if the run waits, and if each run of it would fail in the same way. */
  void keep(DiagnosticException.Reason reason) {
    if (reason == DiagnosticException.Reason.WAITING && last.isPresent() && isSame()) {
      run.models()
          .told()
          .map(verdict -> ResultJson.bytes(new Kept(last.get(), suppressions(), verdict)))
          .ifPresent(json -> run.output().write(FILE, json, OutputFolder.OnEdit.OVERWRITE));
    }
  }

  private String suppressions() {
    return run.options().suppressions().inForce().toString();
  }

  /** Returns whether criteria decided, in simulated time, and no component that did not work. */
  private boolean isSame() {
    return isPossible()
        && run.models().simulated().stream()
            .flatMap(result -> result.verdicts().stream())
            .allMatch(ScenarioVerdict::worked);
  }

  private boolean isPossible() {
    return run.options().simulation().driver() == SimulationOptions.Driver.LOCKSTEP
        && VerdictCorrection.mayFollow(run.options())
        && !run.options().onlyReports()
        && !run.models().isEvaluated();
  }

  /** Returns the failure that was kept, if it was one of these inputs and suppressions. */
  Optional<StageRecord> recall(Fingerprint inputs) {
    Optional<Kept> kept =
        read()
            .filter(each -> inputs.isOf(each.record()))
            .filter(each -> each.suppressions().equals(suppressions()))
            .filter(each -> each.record().isAsWritten(run.output()));
    kept.ifPresent(each -> run.models().failed(each.verdict()));
    last = kept.map(Kept::record);
    return last.map(StandingFailure::again);
  }

  private static StageRecord again(StageRecord kept) {
    return new StageRecord(
        kept.key(),
        kept.sources(),
        kept.outputs(),
        kept.details() + ", nothing has changed since",
        kept.diagnostics(),
        kept.coverage(),
        kept.report());
  }

  private Optional<Kept> read() {
    if (!isPossible()) {
      return Optional.empty();
    }
    try {
      byte[] json = Files.readAllBytes(run.file(FILE));
      return Optional.of(ResultJson.read(json, Kept.class, Stage.SIMULATE));
    } catch (IOException e) {
      // Nothing was kept, or by another version of this program: it is only simulated again.
      return Optional.empty();
    }
  }
}
