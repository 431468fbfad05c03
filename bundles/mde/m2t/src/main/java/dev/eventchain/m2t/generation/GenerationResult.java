package dev.eventchain.m2t.generation;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.output.OutputFolder;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Collectors;

/**
 * What a generation produced. Files are complete as far as the model allowed: each undefined value
 * is reported as an error.
 *
 * @param files the content of each file, by its name relative to the output folder, in {@link
 *     OutputFolder#WRITING_ORDER}; every name is fit for {@link OutputFolder#write}
 * @param printed what blocks of the name {@code stdout} wrote, in order, if it is any text
 * @param diagnostics what was found on the way, in the order of generation
 * @param trace where the lines of the files come from, if the context asked for it
 */
public record GenerationResult(
    SortedMap<String, byte[]> files,
    List<Printed> printed,
    List<Diagnostic> diagnostics,
    GenerationTrace trace) {

  /** What a block printed, and where it is. */
  public record Printed(SourceLocation block, String text) {}

  /** The id of the warning that a protected area of an earlier file is in no block. */
  public static final String LOST_AREA = "m2t.protected.lost";

  /** What is found where a value is undefined, in a template or in a Java service. */
  private static final Set<String> UNDEFINED = Set.of("m2t.undefined", "m2t.service");

  /** Takes copies. */
  public GenerationResult {
    SortedMap<String, byte[]> ordered = new TreeMap<>(OutputFolder.WRITING_ORDER);
    ordered.putAll(files);
    files = Collections.unmodifiableSortedMap(ordered);
    printed = List.copyOf(printed);
    diagnostics = List.copyOf(diagnostics);
  }

  /** All that was printed, one after the other. */
  public String printedText() {
    return printed.stream().map(Printed::text).collect(Collectors.joining());
  }

  /**
   * Whether the files are all that the templates write for the model: nothing is wrong but that
   * values are undefined.
   */
  public boolean isWhole() {
    return diagnostics.stream()
        .noneMatch(found -> found.severity() == Severity.ERROR && !UNDEFINED.contains(found.id()));
  }

  /** What was found, for a caller that writes none of the files: no lost area was saved. */
  public List<Diagnostic> diagnosticsIfUnwritten() {
    return diagnostics.stream().filter(found -> !found.id().equals(LOST_AREA)).toList();
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
