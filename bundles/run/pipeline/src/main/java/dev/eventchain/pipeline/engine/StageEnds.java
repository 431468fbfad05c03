package dev.eventchain.pipeline.engine;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Suppressions.Parted;
import dev.eventchain.pipeline.run.Progress.Status;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.stage.StageOutcome;
import dev.eventchain.pipeline.stage.StageResult;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;

/** Outcomes of stages that ended, stopped or did not run. */
final class StageEnds {

  private StageEnds() {}

  /**
   * Returns the outcome of a stage without a result; its findings cannot be suppressed.
   *
   * @param found the findings before the problem
   * @param start the start in ns, as {@link System#nanoTime} gives it
   */
  static StageOutcome stopped(
      Stage stage, DiagnosticException problem, List<Diagnostic> found, long start) {
    List<Diagnostic> all = new ArrayList<>(found);
    all.addAll(problem.diagnostics());
    return new StageOutcome(
        stage,
        problem.reason() == DiagnosticException.Reason.WAITING ? Status.WAITING : Status.FAILED,
        since(start),
        reason(problem),
        new Parted(all, List.of()),
        Coverage.NONE,
        Optional.empty());
  }

  /** Returns the outcome of a stage with a result. */
  static StageOutcome ended(
      Stage stage, Status status, long start, StageResult result, Parted found) {
    return new StageOutcome(
        stage,
        status,
        since(start),
        result.details(),
        found,
        result.coverage(),
        Optional.of(result.report()));
  }

  /** Returns the outcome of a stage that did not run; earlier results prove nothing here. */
  static StageOutcome notRun(Stage stage) {
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

  /** Returns the first stage that was stopped; there is one. */
  static Stage firstStopped(Collection<StageOutcome> outcomes) {
    return outcomes.stream()
        .filter(outcome -> outcome.status().isStopped())
        .map(StageOutcome::stage)
        .findFirst()
        .orElseThrow();
  }
}
