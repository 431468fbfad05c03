package dev.eventchain.pipeline.stage;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Suppressions.Parted;
import dev.eventchain.pipeline.run.Progress;
import dev.eventchain.pipeline.run.Stage;
import java.time.Duration;
import java.util.List;
import java.util.Optional;

/**
 * How a stage ended in this run.
 *
 * @param duration how long it took, on the host
 * @param found what was found, and of it what is suppressed
 * @param coverage what was checked, in this run or an earlier one
 * @param report what it adds to the report, from this run or an earlier one; empty if it never ran
 */
public record StageOutcome(
    Stage stage,
    Progress.Status status,
    Duration duration,
    String details,
    Parted found,
    Coverage coverage,
    Optional<JsonNode> report) {

  /** The findings that count. */
  public List<Diagnostic> diagnostics() {
    return found.remaining();
  }
}
