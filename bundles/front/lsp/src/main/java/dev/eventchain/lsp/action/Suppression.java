package dev.eventchain.lsp.action;

import dev.eventchain.diagnostics.CommonTrait;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.project.ProjectFolder;
import java.nio.file.Path;
import java.time.LocalDate;
import java.util.Optional;

/**
 * An entry of a project's file of suppressions for a finding. Its reason is missing, and the file
 * is refused until somebody has written one.
 *
 * @param file the file, which may not exist
 * @param text the lines of the entry
 */
record Suppression(Path file, String text) {

  private static final int DAYS = 30;

  /**
   * Returns the entry for a finding of a project; empty if it is about no file, or cannot be
   * suppressed.
   */
  static Optional<Suppression> of(Diagnostic finding, ProjectFolder project, LocalDate today) {
    if (finding.kind().has(CommonTrait.UNSUPPRESSIBLE) || finding.location().file().isEmpty()) {
      return Optional.empty();
    }
    Path place = Path.of(finding.location().file());
    return place.isAbsolute() == project.folder().isAbsolute()
        ? Optional.of(
            new Suppression(
                project.suppressionsFile(),
                entry(finding, named(project.folder().relativize(place)), today)))
        : Optional.empty();
  }

  /** Returns a file of a project as suppressions name it: one from elsewhere by its name. */
  private static Path named(Path inside) {
    return inside.startsWith("..") ? inside.getFileName() : inside;
  }

  private static String entry(Diagnostic finding, Path file, LocalDate today) {
    StringBuilder text = new StringBuilder("- id: " + finding.id() + "\n");
    add(text, "rule", finding.rule());
    add(text, "element", finding.location().element());
    add(text, "file", file.toString());
    return text.append("  expires: ")
        .append(today.plusDays(DAYS))
        .append("\n  reason: \n")
        .toString();
  }

  private static void add(StringBuilder text, String key, String value) {
    if (!value.isEmpty()) {
      text.append("  ").append(key).append(": '").append(value.replace("'", "''")).append("'\n");
    }
  }
}
