package dev.eventchain.pipeline.stage;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;

/**
 * What is remembered of a stage that succeeded, so that it need not run again while nothing
 * changes, and later stages can tell whether what it made is up to date.
 *
 * @param key the fingerprint of everything that the stage read; {@link #NEVER} if it has to run
 *     again anyway
 * @param sources what its results were made from, by {@link SourceName}, as {@link
 *     Fingerprint#sources} gives it
 * @param outputs the files it wrote, relative to the output folder, each with the fingerprint of
 *     what it wrote; empty where a person's file was kept that it never wrote
 * @param details what it made, in a few words
 * @param diagnostics what it found; none of it is an error
 * @param coverage what it checked
 * @param report what it adds to the report
 */
public record StageRecord(
    String key,
    Map<String, String> sources,
    Map<String, String> outputs,
    String details,
    List<Diagnostic> diagnostics,
    Coverage coverage,
    JsonNode report) {
  /** The key of a stage that is not skipped. */
  public static final String NEVER = "";

  /** Refuses what a damaged file leaves out. */
  public StageRecord {
    Objects.requireNonNull(key);
    sources = new TreeMap<>(sources);
    outputs = new TreeMap<>(outputs);
    Objects.requireNonNull(details);
    diagnostics = List.copyOf(diagnostics);
    Objects.requireNonNull(coverage);
    Objects.requireNonNull(report);
  }
}
