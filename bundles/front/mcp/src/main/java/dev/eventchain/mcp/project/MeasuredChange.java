package dev.eventchain.mcp.project;

import dev.eventchain.documents.UnifiedDiff;
import dev.eventchain.project.ProjectLayout;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.List;
import java.util.Optional;

/**
 * The change that {@code eventchain measure} proposes among its results.
 *
 * @param project the project's folder
 * @param earlier the time of a change that was there before, which is none of this measurement
 */
public record MeasuredChange(Path project, Optional<FileTime> earlier) {

  private static final Path DIFF = Path.of(ProjectLayout.OUTPUT, "traced", "measured-times.diff");

  /** Looks at a project before it is measured. */
  public static MeasuredChange before(Path project) {
    return new MeasuredChange(project, time(project));
  }

  private static Optional<FileTime> time(Path project) {
    Path file = project.resolve(DIFF);
    try {
      return Files.exists(file) ? Optional.of(Files.getLastModifiedTime(file)) : Optional.empty();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /**
   * Returns the change of the measurement; empty if it proposes none.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException if it cannot be made, or may not
   */
  public Optional<Proposal> proposal(Boundary boundary) {
    Optional<FileTime> now = time(project);
    if (now.isEmpty() || now.equals(earlier)) {
      return Optional.empty();
    }
    String name = DIFF.toString();
    String diff = ProjectFiles.read(boundary.inside(project, name), name);
    String file = UnifiedDiff.file(diff).orElseThrow(() -> refusal(name));
    String before = ProjectFiles.read(boundary.inside(project, file), file);
    String after = UnifiedDiff.apply(diff, before).orElseThrow(() -> refusal(name));
    return Optional.of(Proposal.of(boundary, project, List.of(new Edit(file, "", after))));
  }

  private static RuntimeException refusal(String file) {
    return McpRules.refusal(
        McpRules.CHANGE,
        file,
        "The measured times do not fit into the file that they are about.",
        "Propose the change with the tool 'propose'.");
  }
}
