package dev.eventchain.mcp.project;

import dev.eventchain.documents.AtomicFile;
import dev.eventchain.documents.UnifiedDiff;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * A change of a project that is not made yet.
 *
 * @param changes the texts of each file, by its name
 */
public record Proposal(Path project, Map<String, Change> changes) {

  private static final int ID_LENGTH = 12;

  /**
   * A file before and after.
   *
   * @param before empty if it is new
   */
  public record Change(Optional<String> before, String after) {}

  /**
   * Returns the change that edits make, one after the other.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException if they cannot be made, or may not
   */
  public static Proposal of(Boundary boundary, Path project, List<Edit> edits) {
    Map<String, Change> changes = new TreeMap<>();
    for (Edit edit : edits) {
      Path file = boundary.inside(project, edit.file());
      String name = Protection.requireChangeable(boundary, project, file, edit.file());
      Change earlier = changes.get(name);
      Optional<String> before = earlier == null ? textOf(file, edit) : earlier.before();
      String now = earlier == null ? before.orElse("") : earlier.after();
      changes.put(name, new Change(before, edit.in(now)));
    }
    changes.values().removeIf(each -> each.before().equals(Optional.of(each.after())));
    if (changes.isEmpty()) {
      throw McpRules.refusal(McpRules.CHANGE, "", "Nothing would change.", "Give other texts.");
    }
    return new Proposal(project, changes);
  }

  private static Optional<String> textOf(Path file, Edit edit) {
    return Files.exists(file)
        ? Optional.of(ProjectFiles.read(file, edit.file()))
        : Optional.empty();
  }

  /**
   * Returns the name by which the client can have it made: a hash of everything that decides what
   * is written, of which the diff shows only a part.
   */
  public String id() {
    StringBuilder all = new StringBuilder();
    append(all, project.toString());
    changes.forEach(
        (name, change) -> {
          append(all, name);
          all.append(change.before().isPresent() ? "changed " : "new ");
          append(all, change.before().orElse(""));
          append(all, change.after());
        });
    try {
      byte[] digest =
          MessageDigest.getInstance("SHA-256")
              .digest(all.toString().getBytes(StandardCharsets.UTF_8));
      return HexFormat.of().formatHex(digest).substring(0, ID_LENGTH);
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException(e);
    }
  }

  /** Adds a text with its length, so that no other texts in a row look the same. */
  private static void append(StringBuilder all, String text) {
    all.append(text.length()).append(' ').append(text);
  }

  /** Returns the files that say what is right: a change of them changes what a verdict means. */
  public List<String> judges() {
    return changes.keySet().stream().filter(Protection::judges).toList();
  }

  /**
   * Returns the change as a unified diff, in which a carriage return is visible as {@code ␍}, and
   * the lack of a last end of line as usual.
   */
  public String diff() {
    StringBuilder diff = new StringBuilder();
    changes.forEach((name, change) -> diff.append(diff(name, change)));
    return diff.toString().replace('\r', '␍');
  }

  private static String diff(String name, Change change) {
    return change.after().isEmpty() && change.before().isEmpty()
        ? "--- /dev/null\n+++ b/" + name + "\n\\ New empty file\n"
        : UnifiedDiff.of(name, change.before(), change.after());
  }

  /**
   * Writes the files.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException if a file has changed since, or may not
   *     be changed any more
   */
  public void apply(Boundary boundary) {
    changes.forEach(
        (name, change) -> {
          Path file = boundary.inside(project, name);
          Protection.requireChangeable(boundary, project, file, name);
          Optional<String> now =
              Files.exists(file) ? Optional.of(ProjectFiles.read(file, name)) : Optional.empty();
          if (!now.equals(change.before())) {
            throw McpRules.refusal(
                McpRules.CHANGE,
                name,
                "The file has changed since the proposal was made.",
                "Propose the change again.");
          }
        });
    writeTo(project);
  }

  /** Writes the files into a folder, which may be a copy of the project. */
  void writeTo(Path folder) {
    changes.forEach(
        (name, change) -> {
          try {
            AtomicFile.write(folder.resolve(name), change.after());
          } catch (IOException e) {
            throw new UncheckedIOException(e);
          }
        });
  }
}
