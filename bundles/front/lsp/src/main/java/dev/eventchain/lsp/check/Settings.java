package dev.eventchain.lsp.check;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.constraints.OclValidator;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;

/**
 * Settings of an editor.
 *
 * @param metamodels Ecore files that count for all templates, rules and models; relative ones are
 *     below the folder of the workspace
 * @param timeLimit the processor time that a constraint may take on a model
 */
public record Settings(List<String> metamodels, Duration timeLimit) {

  private static final List<String> KEYS = List.of("eventchain", "metamodels", "timeLimit");

  /** Settings where nothing is set. */
  public static final Settings USUAL = new Settings(List.of(), OclValidator.TIME_LIMIT);

  /**
   * Reads settings; what is missing or of a wrong type counts as not set.
   *
   * @param given an object with {@code metamodels} and {@code timeLimit}, alone or inside {@code
   *     eventchain}
   * @param before settings that stay if there is no such object: some editors tell that something
   *     has changed and not what
   */
  public static Settings of(JsonNode given, Settings before) {
    if (KEYS.stream().noneMatch(given::has)) {
      return before;
    }
    JsonNode inner = given.path("eventchain");
    JsonNode settings = inner.isObject() ? inner : given;
    List<String> metamodels = new ArrayList<>();
    JsonNode files = settings.path("metamodels");
    for (int i = 0; files.isArray() && i < files.size(); i++) {
      if (files.get(i).isValueNode() && !files.get(i).isNull()) {
        metamodels.add(files.get(i).asText());
      }
    }
    JsonNode seconds = settings.path("timeLimit");
    boolean limited = seconds.isNumber() && seconds.asLong() > 0;
    return new Settings(
        List.copyOf(metamodels),
        limited ? Duration.ofSeconds(seconds.asLong()) : OclValidator.TIME_LIMIT);
  }

  /** Returns the metamodels as paths, in the first folder of a workspace. */
  List<Path> metamodelsIn(List<Path> folders) {
    List<Path> found = new ArrayList<>();
    for (String each : metamodels) {
      try {
        Path file = folders.isEmpty() ? Path.of(each) : folders.get(0).resolve(each);
        found.add(file.toAbsolutePath().normalize());
      } catch (InvalidPathException e) {
        // No path on this system, so it names no file.
      }
    }
    return found;
  }
}
