package dev.eventchain.m2t;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.output.OutputFolder;
import java.util.Collections;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * What a generation made. Files are complete as far as the model allowed: a part whose value is
 * undefined is left out, and an error says so.
 *
 * @param files the content of each file, by its name relative to the output folder, in {@link
 *     OutputFolder#WRITING_ORDER}; every name is fit for {@link OutputFolder#write}
 * @param diagnostics what was found on the way, in the order of generation
 * @param trace where the lines of the files come from, if the context asked for it
 */
public record GenerationResult(
    SortedMap<String, byte[]> files, List<Diagnostic> diagnostics, GenerationTrace trace) {

  /** Takes copies. */
  public GenerationResult {
    SortedMap<String, byte[]> ordered = new TreeMap<>(OutputFolder.WRITING_ORDER);
    ordered.putAll(files);
    files = Collections.unmodifiableSortedMap(ordered);
    diagnostics = List.copyOf(diagnostics);
  }
}
