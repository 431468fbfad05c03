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

/** Files written by a command without a project, and the findings. */
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

  /** Records that a generation is incomplete, so that none of its files is written. */
  public void wroteNothing() {
    isRefused = true;
  }

  /** Returns the text that templates printed outside of files. */
  public String printed() {
    return printed;
  }

  /**
   * Returns the findings; files are written unless there are errors other than undefined values.
   */
  public List<Diagnostic> diagnostics() {
    return List.copyOf(found);
  }

  /**
   * Returns a summary for people: {@code 3 files in out: 1 written, 2 unchanged}; or that nothing
   * was written because of errors; or empty without files.
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
