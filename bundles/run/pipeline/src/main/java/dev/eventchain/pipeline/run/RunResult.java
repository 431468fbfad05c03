package dev.eventchain.pipeline.run;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Suppressions.Suppressed;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * How a run ended.
 *
 * @param verdict what it comes to
 * @param summary the verdict in a sentence
 * @param scenarios a line for each scenario that was simulated
 * @param diagnostics everything that was found, in order of the stages, but for what is suppressed
 * @param suppressed what was found and is suppressed
 * @param coverage what was checked
 * @param report the report, when one was written
 * @param failure why the run could not continue, when it could not
 * @param recordings the messages of scenarios, where they were recorded
 * @param faults a line for each run with a fault
 */
public record RunResult(
    Verdict verdict,
    String summary,
    List<ScenarioLine> scenarios,
    List<Diagnostic> diagnostics,
    List<Suppressed> suppressed,
    Coverage coverage,
    Optional<Path> report,
    Optional<DiagnosticException.Reason> failure,
    List<Path> recordings,
    List<FaultLine> faults) {

  /** Without recordings. */
  public RunResult(
      Verdict verdict,
      String summary,
      List<ScenarioLine> scenarios,
      List<Diagnostic> diagnostics,
      List<Suppressed> suppressed,
      Coverage coverage,
      Optional<Path> report,
      Optional<DiagnosticException.Reason> failure) {
    this(
        verdict,
        summary,
        scenarios,
        diagnostics,
        suppressed,
        coverage,
        report,
        failure,
        List.of(),
        List.of());
  }

  /** The same with recordings. */
  public RunResult withRecordings(List<Path> files) {
    return new RunResult(
        verdict,
        summary,
        scenarios,
        diagnostics,
        suppressed,
        coverage,
        report,
        failure,
        files,
        faults);
  }

  /** The same with what came of faults. */
  public RunResult withFaults(List<FaultLine> lines) {
    return new RunResult(
        verdict,
        summary,
        scenarios,
        diagnostics,
        suppressed,
        coverage,
        report,
        failure,
        recordings,
        lines);
  }

  /** What a run comes to. */
  public enum Verdict {
    /** Every stage asked for ran, no finding is an error, and every scenario met its criteria. */
    PASSED,
    /** Something was found wrong. */
    FAILED,
    /**
     * Nothing was found wrong, but not everything was run or tested that a verdict needs: then it
     * is a finding, unless it was not asked for.
     */
    INCOMPLETE
  }

  /**
   * A scenario in a line.
   *
   * @param name the scenario's name
   * @param tested whether all components worked and every criterion could be judged, or one fails
   * @param passed whether it met its criteria
   * @param text what happened, in a sentence
   */
  public record ScenarioLine(String name, boolean tested, boolean passed, String text) {}

  /**
   * A run with a fault in a line.
   *
   * @param name the fault's name
   * @param tested whether something was expected and all of it could be judged, or one fails
   * @param passed whether it was judged and everything expected holds
   * @param text what happened, in a sentence
   */
  public record FaultLine(String name, boolean tested, boolean passed, String text) {}
}
