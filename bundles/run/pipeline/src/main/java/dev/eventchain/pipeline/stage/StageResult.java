package dev.eventchain.pipeline.stage;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.pipeline.results.StageReport;
import java.util.List;

/**
 * The result of a stage.
 *
 * @param details a short description of its results
 * @param outputs the files it wrote, relative to the output folder
 * @param diagnostics its findings
 * @param report its part of the report
 * @param coverage the coverage of its checks
 */
public record StageResult(
    String details,
    List<String> outputs,
    List<Diagnostic> diagnostics,
    StageReport report,
    Coverage coverage) {

  /** Creates the result of a stage without checks. */
  public StageResult(
      String details, List<String> outputs, List<Diagnostic> diagnostics, StageReport report) {
    this(details, outputs, diagnostics, report, Coverage.NONE);
  }

  public static StageResult of(String details, List<String> outputs, List<Diagnostic> diagnostics) {
    return new StageResult(details, outputs, diagnostics, new StageReport.None());
  }
}
