package dev.eventchain.pipeline.files;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.output.OutputFolder;
import dev.eventchain.output.OutputFolder.OnEdit;
import dev.eventchain.output.OutputFolder.Outcome;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/** The files that a command without a project made, and what was found on the way. */
public final class WrittenFiles {

  private final Optional<Path> folder;
  private String printed = "";
  private boolean isRefused;
  private final List<Diagnostic> found = new ArrayList<>();
  private final Map<Outcome, Integer> counts = new EnumMap<>(Outcome.class);

  public WrittenFiles(Optional<Path> folder) {
    this.folder = folder;
  }

  public void print(String text) {
    printed = text;
  }

  public void found(List<Diagnostic> diagnostics) {
    found.addAll(diagnostics);
  }

  public void write(OutputFolder output, Map<String, byte[]> files, OnEdit onEdit) {
    files.forEach(
        (name, content) -> {
          OutputFolder.Written written = output.write(name, content, onEdit);
          written.finding().ifPresent(found::add);
          counts.merge(written.outcome(), 1, Integer::sum);
        });
  }

  /** Notes that a generation was not whole, so that none of its files is written. */
  public void wroteNothing() {
    isRefused = true;
  }

  /** What templates printed instead of writing a file. */
  public String printed() {
    return printed;
  }

  /** What was found; values that are undefined, and nothing else, leave files to be written. */
  public List<Diagnostic> diagnostics() {
    return List.copyOf(found);
  }

  /**
   * For people: {@code 3 files in out: 1 written, 2 unchanged}; that nothing was written because of
   * errors; or empty if there are no files.
   */
  public String summary() {
    if (isRefused) {
      return "nothing was written in " + folder.orElseThrow().normalize();
    }
    int files = counts.values().stream().mapToInt(Integer::intValue).sum();
    List<String> parts = new ArrayList<>();
    counts.forEach(
        (outcome, count) -> parts.add(count + " " + outcome.name().toLowerCase(Locale.ROOT)));
    return files == 0
        ? ""
        : Coverage.counted(files, "file")
            + " in "
            + folder.orElseThrow().normalize()
            + ": "
            + String.join(", ", parts);
  }
}
