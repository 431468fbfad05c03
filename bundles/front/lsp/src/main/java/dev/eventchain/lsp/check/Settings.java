package dev.eventchain.lsp.check;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
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
  public static Settings of(Object given, Settings before) {
    if (!(given instanceof JsonObject object) || KEYS.stream().noneMatch(object::has)) {
      return before;
    }
    JsonObject settings = object.get("eventchain") instanceof JsonObject inner ? inner : object;
    List<String> metamodels = new ArrayList<>();
    if (settings.get("metamodels") instanceof JsonArray list) {
      for (JsonElement each : list) {
        if (each.isJsonPrimitive()) {
          metamodels.add(each.getAsString());
        }
      }
    }
    JsonElement seconds = settings.get("timeLimit");
    boolean limited =
        seconds != null
            && seconds.isJsonPrimitive()
            && seconds.getAsJsonPrimitive().isNumber()
            && seconds.getAsLong() > 0;
    return new Settings(
        List.copyOf(metamodels),
        limited ? Duration.ofSeconds(seconds.getAsLong()) : OclValidator.TIME_LIMIT);
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
