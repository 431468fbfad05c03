package dev.eventchain.pipeline;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import java.util.List;
import java.util.Objects;

/**
 * What is remembered of a stage that succeeded, so that it need not run again while nothing
 * changes.
 *
 * @param key the fingerprint of everything that the stage read
 * @param outputs the files it wrote, relative to the output folder, sorted
 * @param details what it made, in a few words
 * @param diagnostics what it found; none of it is an error
 * @param coverage what it checked
 * @param report what it adds to the report
 */
record StageRecord(
    String key,
    List<String> outputs,
    String details,
    List<Diagnostic> diagnostics,
    Coverage coverage,
    JsonNode report) {
  /** Refuses what a damaged file leaves out. */
  StageRecord {
    Objects.requireNonNull(key);
    outputs = List.copyOf(outputs);
    Objects.requireNonNull(details);
    diagnostics = List.copyOf(diagnostics);
    Objects.requireNonNull(coverage);
    Objects.requireNonNull(report);
  }
}
