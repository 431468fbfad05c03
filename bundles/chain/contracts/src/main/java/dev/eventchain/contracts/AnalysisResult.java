package dev.eventchain.contracts;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import java.util.List;

/**
 * Result of an analysis.
 *
 * @param diagnostics the findings, in their order
 * @param checks the number of evaluations of each rule, including rules that did not apply
 */
public record AnalysisResult(List<Diagnostic> diagnostics, List<Coverage.Check> checks) {

  /** Copies the lists. */
  public AnalysisResult {
    diagnostics = List.copyOf(diagnostics);
    checks = List.copyOf(checks);
  }
}
