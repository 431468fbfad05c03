package dev.eventchain.pipeline.stage;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Suppressions.Parted;
import dev.eventchain.pipeline.results.StageReport;
import dev.eventchain.pipeline.run.Progress;
import dev.eventchain.pipeline.run.Stage;
import java.time.Duration;
import java.util.List;
import java.util.Optional;

/**
 * The outcome of a stage in this run.
 *
 * @param duration the duration on the host
 * @param found the findings, with suppressed ones apart
 * @param coverage the coverage of the checks, from this run or an earlier one
 * @param report its part of the report, from this run or an earlier one; empty if it never ran
 */
public record StageOutcome(
    Stage stage,
    Progress.Status status,
    Duration duration,
    String details,
    Parted found,
    Coverage coverage,
    Optional<StageReport> report) {

  /** Returns its part of the report if it ever ran and its part is of this type. */
  public <T extends StageReport> Optional<T> report(Class<T> type) {
    return report.filter(type::isInstance).map(type::cast);
  }

  /** Returns the findings that are not suppressed. */
  public List<Diagnostic> diagnostics() {
    return found.remaining();
  }
}
