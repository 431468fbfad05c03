package dev.eventchain.m2t.generation;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.output.OutputFolder;
import java.util.Collections;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Collectors;

/**
 * Result of a generation. Files are complete except for undefined values, each of which is reported
 * as an error.
 *
 * @param files the contents by file name relative to the output folder, in {@link
 *     OutputFolder#WRITING_ORDER}; every name is valid for {@link OutputFolder#write}
 * @param printed the non-empty texts of blocks named {@code stdout}, in order
 * @param diagnostics the findings, in the order of generation
 * @param trace the origins of the lines of the files, if the context requests them
 */
public record GenerationResult(
    SortedMap<String, byte[]> files,
    List<Printed> printed,
    List<Diagnostic> diagnostics,
    GenerationTrace trace) {

  /** Text printed by a block, with the location of the block. */
  public record Printed(SourceLocation block, String text) {}

  /** Copies the collections. */
  public GenerationResult {
    SortedMap<String, byte[]> ordered = new TreeMap<>(OutputFolder.WRITING_ORDER);
    ordered.putAll(files);
    files = Collections.unmodifiableSortedMap(ordered);
    printed = List.copyOf(printed);
    diagnostics = List.copyOf(diagnostics);
  }

  /** Returns the concatenated printed texts. */
  public String printedText() {
    return printed.stream().map(Printed::text).collect(Collectors.joining());
  }

  /** Returns whether the files are complete: there are no errors except undefined values. */
  public boolean isWhole() {
    return diagnostics.stream()
        .noneMatch(
            found ->
                found.severity() == Severity.ERROR && !found.kind().has(GenerationTrait.UNDEFINED));
  }

  /** Returns the findings for a caller that writes no files, so that no lost area is saved. */
  public List<Diagnostic> diagnosticsIfUnwritten() {
    return diagnostics.stream().filter(found -> !found.is(GenerationRules.PROTECTED_LOST)).toList();
  }

  /** Returns this result with warnings instead of errors for undefined values. */
  public GenerationResult lenient() {
    List<Diagnostic> milder =
        diagnostics.stream()
            .map(
                found ->
                    found.severity() == Severity.ERROR
                            && found.kind().has(GenerationTrait.UNDEFINED)
                        ? found.withSeverity(Severity.WARNING)
                        : found)
            .toList();
    return new GenerationResult(files, printed, milder, trace);
  }
}
