package dev.eventchain.pipeline.mutation;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.pipeline.project.Project;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Lines of files that have changed since a revision of Git, committed or not. */
final class ChangedLines {

  private static final Pattern COMMIT = Pattern.compile("[0-9a-f]{40}|[0-9a-f]{64}");

  /** The head of a changed part, with first line and number of lines in the current file. */
  private static final Pattern PART = Pattern.compile("(?m)^@@ -\\S+ \\+(\\d+)(?:,(\\d+))? @@");

  private final Path folder;
  private final String revision;
  private final String commit;
  private final Map<Path, Optional<BitSet>> known = new HashMap<>();

  /** What a program has said. */
  private record Answer(int exitCode, String text) {}

  /**
   * Prepares the comparison.
   *
   * @throws DiagnosticException INPUT, {@code mutation.since}: the project is not in a repository,
   *     or it has no such revision; UNAVAILABLE if there is no Git
   */
  ChangedLines(Project project, String revision) {
    this.folder = project.folder().toAbsolutePath();
    this.revision = revision;
    Answer answer =
        git("rev-parse", "--verify", "--quiet", "--end-of-options", revision + "^{commit}");
    this.commit = answer.text().strip();
    if (answer.exitCode() != 0 || !COMMIT.matcher(commit).matches()) {
      throw failure(
          DiagnosticException.Reason.INPUT,
          "'" + revision + "' is not a revision of a Git repository that holds the project.");
    }
  }

  /** Returns whether a mutant is in a changed line; every line of a file unknown to Git is. */
  boolean hold(Mutant mutant) {
    Optional<BitSet> lines =
        known.computeIfAbsent(mutant.file().toAbsolutePath().normalize(), this::lines);
    return lines.isEmpty()
        || mutant.defect().lines(mutant.source().text()).anyMatch(lines.get()::get);
  }

  private Optional<BitSet> lines(Path file) {
    if (git("ls-files", "--error-unmatch", "--", file.toString()).exitCode() != 0) {
      return Optional.empty();
    }
    Answer answer =
        git(
            "diff",
            "--unified=0",
            "--no-color",
            "--no-ext-diff",
            "--no-textconv",
            commit,
            "--",
            file.toString());
    if (answer.exitCode() != 0) {
      throw failure(
          DiagnosticException.Reason.INPUT, "Git cannot compare with '" + revision + "'.");
    }
    BitSet lines = new BitSet();
    Matcher part = PART.matcher(answer.text());
    while (part.find()) {
      int first = Integer.parseInt(part.group(1));
      int count = part.group(2) == null ? 1 : Integer.parseInt(part.group(2));
      lines.set(first, first + count);
    }
    return Optional.of(lines);
  }

  private Answer git(String... arguments) {
    List<String> command = new ArrayList<>(List.of("git", "-C", folder.toString()));
    command.addAll(List.of(arguments));
    ProcessBuilder builder = new ProcessBuilder(command);
    builder.redirectError(ProcessBuilder.Redirect.DISCARD);
    try {
      Process process = builder.start();
      process.getOutputStream().close();
      String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      return new Answer(process.waitFor(), text);
    } catch (IOException e) {
      throw failure(
          DiagnosticException.Reason.UNAVAILABLE, "There is no Git, which --since needs.");
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException(e);
    }
  }

  private DiagnosticException failure(DiagnosticException.Reason reason, String message) {
    return new DiagnosticException(
        reason,
        Diagnostic.of(MutationRules.MUTATION_SINCE, message, SourceLocation.of(folder))
            .withHint("Leave out --since to try all mutants."));
  }
}
