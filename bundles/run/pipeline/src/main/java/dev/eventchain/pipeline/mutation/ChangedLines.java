package dev.eventchain.pipeline.mutation;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.pipeline.project.Project;
import java.nio.file.Path;
import java.time.Duration;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Lines of files that have changed since a revision of Git, committed or not. */
final class ChangedLines {

  private static final Duration PATIENCE = Duration.ofSeconds(30);

  private static final Pattern COMMIT = Pattern.compile("[0-9a-f]{40}|[0-9a-f]{64}");

  /** The head of a changed part, with first line and number of lines in the current file. */
  private static final Pattern PART = Pattern.compile("(?m)^@@ -\\S+ \\+(\\d+)(?:,(\\d+))? @@");

  private final Git git;
  private final String revision;
  private final String commit;
  private final Map<Path, Optional<BitSet>> known = new HashMap<>();

  /**
   * Prepares the comparison.
   *
   * @throws DiagnosticException INPUT, {@code mutation.since}: the project is not in a repository,
   *     or it has no such revision; UNAVAILABLE if there is no Git, or none that answers
   */
  ChangedLines(Project project, String revision) {
    this.git = new Git(List.of("git"), project.folder().toAbsolutePath(), PATIENCE);
    this.revision = revision;
    Git.Answer answer =
        git.ask("rev-parse", "--verify", "--quiet", "--end-of-options", revision + "^{commit}");
    this.commit = answer.text().strip();
    if (answer.exitCode() != 0 || !COMMIT.matcher(commit).matches()) {
      throw git.failure(
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
    if (git.ask("ls-files", "--error-unmatch", "--", file.toString()).exitCode() != 0) {
      return Optional.empty();
    }
    Git.Answer answer =
        git.ask(
            "diff",
            "--unified=0",
            "--no-color",
            "--no-ext-diff",
            "--no-textconv",
            commit,
            "--",
            file.toString());
    if (answer.exitCode() != 0) {
      throw git.failure(
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
}
