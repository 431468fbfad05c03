package dev.eventchain.pipeline.stage;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.FileReads.Recorded;
import dev.eventchain.output.OutputFolder;
import dev.eventchain.pipeline.results.StageReport;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;

/**
 * The record of a successful stage: the stage is skipped while its inputs are unchanged, and later
 * stages can tell whether its results are up to date.
 *
 * @param key the fingerprint of the inputs that were known before the stage ran; {@link #NEVER} if
 *     it has to run again anyway
 * @param sources the fingerprints of its results' sources and of all files that it read, by {@link
 *     SourceName}
 * @param outputs the files it wrote, relative to the output folder, each with the fingerprint of
 *     the written content; empty for a person's file that was kept
 * @param details a short description of its results
 * @param diagnostics its findings; errors among them were suppressed
 * @param coverage the coverage of its checks
 * @param report its part of the report
 */
public record StageRecord(
    String key,
    Map<String, String> sources,
    Map<String, String> outputs,
    String details,
    List<Diagnostic> diagnostics,
    Coverage coverage,
    StageReport report) {
  /** The key of a stage that is not skipped. */
  public static final String NEVER = "";

  /**
   * Creates the record of a stage that has just ended.
   *
   * @param inputs those that were known before
   * @param done its result, with the files that it read
   * @param found its findings
   */
  public static StageRecord of(
      String key,
      Fingerprint inputs,
      Recorded<StageResult> done,
      OutputFolder output,
      List<Diagnostic> found) {
    StageResult result = done.value();
    Map<String, String> outputs = new TreeMap<>();
    result.outputs().forEach(name -> outputs.put(name, output.written(name)));
    return new StageRecord(
        key,
        inputs.sources(done.files(), result.outputs()),
        outputs,
        result.details(),
        found,
        result.coverage(),
        result.report());
  }

  /** Returns whether an output folder has all files as the stage wrote them. */
  public boolean isAsWritten(OutputFolder output) {
    return outputs.entrySet().stream()
        .allMatch(
            each ->
                output.read(each.getKey()).isPresent()
                    && !output.isEdited(each.getKey())
                    && output.written(each.getKey()).equals(each.getValue()));
  }

  /** Rejects missing values, as from a damaged file. */
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
