package dev.eventchain.editing;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * Answers to what editors ask about the files of a language. Keeps what it knows of each version of
 * a text, and is thread-safe.
 */
public interface LanguageService {

  /** Returns whether a file is of the language, by its name. */
  boolean handles(Path file);

  /**
   * Returns the analysis of the present text of a file; empty if the workspace has no such text.
   */
  Optional<Analysis> analysis(Path file);

  /** Returns who calls something, in all files of the language. */
  List<Call> incomingCalls(Call.Item item);

  /** Returns what something calls. */
  List<Call> outgoingCalls(Call.Item item);
}
