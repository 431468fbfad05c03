package dev.eventchain.pipeline;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import java.time.Duration;
import java.util.List;
import java.util.Optional;

/**
 * How a stage ended in this run.
 *
 * @param duration how long it took, on the host
 * @param report what it adds to the report, from this run or an earlier one; empty if it never ran
 */
record StageOutcome(
    Stage stage,
    Progress.Status status,
    Duration duration,
    String details,
    List<Diagnostic> diagnostics,
    Optional<JsonNode> report) {}
