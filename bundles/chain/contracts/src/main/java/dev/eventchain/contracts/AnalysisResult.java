package dev.eventchain.contracts;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import java.util.List;

/**
 * What an analysis found.
 *
 * @param diagnostics the findings, in their order
 * @param checks how often each rule was checked, also those that there was nothing to check for
 */
public record AnalysisResult(List<Diagnostic> diagnostics, List<Coverage.Check> checks) {

  /** Keeps copies of the lists. */
  public AnalysisResult {
    diagnostics = List.copyOf(diagnostics);
    checks = List.copyOf(checks);
  }
}
