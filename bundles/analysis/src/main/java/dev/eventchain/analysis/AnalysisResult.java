package dev.eventchain.analysis;

import dev.eventchain.diagnostics.Diagnostic;
import java.util.List;

/**
 * What an analysis found.
 *
 * @param diagnostics the findings, in their order
 * @param checks how often each rule was checked, also those that there was nothing to check for
 */
public record AnalysisResult(List<Diagnostic> diagnostics, List<Check> checks) {

  /**
   * What was done for one rule.
   *
   * @param rule the id of its findings
   * @param count how often it was checked; 0 where nothing in the model is of its concern
   */
  public record Check(String rule, long count) {}

  /** Keeps copies of the lists. */
  public AnalysisResult {
    diagnostics = List.copyOf(diagnostics);
    checks = List.copyOf(checks);
  }

  /** How many checks were done, of all rules. */
  public long checked() {
    return checks.stream().mapToLong(Check::count).sum();
  }
}
