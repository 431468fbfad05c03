package dev.eventchain.diagnostics;

import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;

/**
 * Texts that people are editing, which a piece of work reads instead of what their files hold on
 * disk. Those who read a file ask for its text here first, and then know nothing of editors. Work
 * in threads that it starts reads the same texts.
 */
public final class UnsavedTexts {

  private static final InheritableThreadLocal<Map<Path, String>> CURRENT =
      new InheritableThreadLocal<>();

  private UnsavedTexts() {}

  /**
   * Does work that reads texts instead of files.
   *
   * @param texts without byte order marks, by the absolute, normalized paths of their files; must
   *     not change meanwhile
   */
  public static <T> T during(Map<Path, String> texts, Supplier<T> work) {
    return WorkScope.during(CURRENT, texts, work);
  }

  /** Returns the text that the current work reads instead of a file; empty if it reads the file. */
  public static Optional<String> of(Path file) {
    return WorkScope.current(CURRENT)
        .filter(texts -> !texts.isEmpty())
        .map(texts -> texts.get(file.toAbsolutePath().normalize()));
  }
}
