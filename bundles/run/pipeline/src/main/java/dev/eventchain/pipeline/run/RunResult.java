package dev.eventchain.pipeline.run;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Suppressions.Suppressed;
import dev.eventchain.diagnostics.Trial;
import dev.eventchain.pipeline.evidence.Evidence;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * The result of a run.
 *
 * @param verdict the verdict
 * @param summary the verdict in a sentence
 * @param scenarios a line for each scenario that was simulated
 * @param diagnostics the findings that are not suppressed, in order of the stages
 * @param suppressed the suppressed findings
 * @param coverage the number of checks
 * @param report the report, when one was written
 * @param failure the reason why the run could not continue, if it could not
 * @param recordings the messages of scenarios, where they were recorded
 * @param faults a line for each run with a fault
 * @param trials the scenarios, criteria, requirements, faults and component tests as tests with
 *     outcomes
 * @param requirements a line for each requirement that was judged
 * @param evidence what the run says about each requirement
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
    List<FaultLine> faults,
    List<Trial> trials,
    List<RequirementLine> requirements,
    Evidence evidence) {

  /** Returns a copy with recordings. */
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
        faults,
        trials,
        requirements,
        evidence);
  }

  /** The verdicts of a run. */
  public enum Verdict {
    /** All requested stages ran without errors, and every scenario met its criteria. */
    PASSED,
    /** At least one error. */
    FAILED,
    /**
     * No errors, but not everything that a verdict needs was run or tested: a finding, unless it
     * was not requested.
     */
    INCOMPLETE
  }

  /**
   * The summary of a scenario in one line.
   *
   * @param name the scenario's name
   * @param tested true if all components worked and every criterion could be judged, or one fails
   * @param passed true if it met its criteria
   * @param text the course of events, in a sentence
   */
  public record ScenarioLine(String name, boolean tested, boolean passed, String text) {}

  /**
   * The summary of a run with a fault in one line.
   *
   * @param name the fault's name
   * @param tested true if something was expected and all of it could be judged, or one fails
   * @param passed true if it was judged and everything expected holds
   * @param text the course of events, in a sentence
   */
  public record FaultLine(String name, boolean tested, boolean passed, String text) {}

  /**
   * The outcome of a requirement in one line.
   *
   * @param id the requirement's identifier
   * @param outcome "proved", "violated" or "not tested"
   * @param strength the faults that its criteria notice, in words
   */
  public record RequirementLine(String id, String outcome, String strength) {}
}
