package dev.eventchain.m2t;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.output.OutputFolder;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * What a generation made. Files are complete as far as the model allowed: what counts for a value
 * that is undefined is said by an error.
 *
 * @param files the content of each file, by its name relative to the output folder, in {@link
 *     OutputFolder#WRITING_ORDER}; every name is fit for {@link OutputFolder#write}
 * @param printed what blocks of the name {@code stdout} wrote, one after the other
 * @param diagnostics what was found on the way, in the order of generation
 * @param trace where the lines of the files come from, if the context asked for it
 */
public record GenerationResult(
    SortedMap<String, byte[]> files,
    String printed,
    List<Diagnostic> diagnostics,
    GenerationTrace trace) {

  /** What is found where a value is undefined, in a template or in a Java service. */
  private static final Set<String> UNDEFINED = Set.of("m2t.undefined", "m2t.service");

  /** Takes copies. */
  public GenerationResult {
    SortedMap<String, byte[]> ordered = new TreeMap<>(OutputFolder.WRITING_ORDER);
    ordered.putAll(files);
    files = Collections.unmodifiableSortedMap(ordered);
    diagnostics = List.copyOf(diagnostics);
  }

  /**
   * Whether the files are all that the templates write for the model: nothing is wrong but that
   * values are undefined.
   */
  public boolean isWhole() {
    return diagnostics.stream()
        .noneMatch(found -> found.severity() == Severity.ERROR && !UNDEFINED.contains(found.id()));
  }

  /** The same with a warning, in place of an error, for each value that is undefined. */
  public GenerationResult lenient() {
    List<Diagnostic> milder =
        diagnostics.stream()
            .map(
                found ->
                    found.severity() == Severity.ERROR && UNDEFINED.contains(found.id())
                        ? found.withSeverity(Severity.WARNING)
                        : found)
            .toList();
    return new GenerationResult(files, printed, milder, trace);
  }
}
