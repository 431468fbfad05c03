package dev.eventchain.pipeline.evaluation;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.FileRules;
import dev.eventchain.diagnostics.SourceLocation;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Recorded sessions with any chat: a folder for each, with the answers under the names that a
 * hand-off gives to its prompts, {@code TASK-NN.answer.md}. They are given in the rounds of a
 * hand-off: what is asked at once is answered at once.
 *
 * @param folders the sessions, by name
 */
record AnswerSets(List<Path> folders) {

  private static final String SOURCE = "answers:";
  static final String ANSWER = ".answer.md";

  /**
   * Reads the sessions that a source of answers names.
   *
   * @return empty for any other source
   * @throws DiagnosticException INPUT if there are none
   */
  static Optional<AnswerSets> of(String source) {
    if (!source.startsWith(SOURCE)) {
      return Optional.empty();
    }
    String folder = source.substring(SOURCE.length());
    List<Path> sets = sets(path(folder));
    if (sets.isEmpty()) {
      throw none(folder, "There is no answer in it, and in no folder of it.");
    }
    return Optional.of(new AnswerSets(sets));
  }

  private static Path path(String folder) {
    try {
      return Path.of(folder);
    } catch (InvalidPathException e) {
      throw none(folder, "This is no folder: " + e.getReason() + ".");
    }
  }

  private static List<Path> sets(Path folder) {
    if (!Files.isDirectory(folder)) {
      throw none(folder.toString(), "There is no such folder.");
    }
    if (!answers(folder).isEmpty()) {
      return List.of(folder);
    }
    return listed(folder).stream()
        .filter(each -> Files.isDirectory(each) && !answers(each).isEmpty())
        .toList();
  }

  private static DiagnosticException none(String folder, String why) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.of(FileRules.MISSING, why, SourceLocation.of(folder))
            .withHint("Put each session into a folder of its own: RUN/TASK-NN.answer.md."));
  }

  /** Returns the name under which the sessions are compared. */
  String name() {
    Path first = folders.get(0).toAbsolutePath().normalize();
    Path named = folders.size() == 1 ? first : first.getParent();
    return String.valueOf(named.getFileName()).replaceAll("[^A-Za-z0-9._-]", "_");
  }

  /** Returns all answers of all sessions. */
  List<Path> files() {
    return folders.stream().flatMap(folder -> answers(folder).stream()).toList();
  }

  /** Returns the answers of a session, in the order of their names. */
  static List<Path> answers(Path session) {
    return listed(session).stream().filter(file -> file.toString().endsWith(ANSWER)).toList();
  }

  /** Returns the files and folders in a folder, in the order of their names. */
  static List<Path> listed(Path folder) {
    try (Stream<Path> files = Files.list(folder)) {
      return files.sorted().toList();
    } catch (IOException e) {
      throw FileRules.refusal("The folder", folder, e);
    }
  }
}
