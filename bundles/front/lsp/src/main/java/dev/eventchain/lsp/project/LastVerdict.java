package dev.eventchain.lsp.project;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;
import com.google.gson.JsonPrimitive;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.lsp.text.OpenText;
import dev.eventchain.lsp.text.OpenTexts;
import dev.eventchain.project.ProjectFolder;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.math.BigDecimal;
import java.math.MathContext;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The verdict of a project's last run, and whether files have changed since. */
final class LastVerdict {

  /** The file of the verdict among the results. */
  static final String FILE = "verdict.json";

  private static final int DEEPEST = 8;
  private static final MathContext DIGITS = new MathContext(3);

  private final JsonObject verdict;
  private final boolean isOlder;

  private LastVerdict(JsonObject verdict, boolean isOlder) {
    this.verdict = verdict;
    this.isOlder = isOlder;
  }

  /** Reads the verdict; empty if there is none, or no run has got as far. */
  static Optional<LastVerdict> of(ProjectFolder project, OpenTexts texts) {
    Path file = project.defaultOutput().resolve(FILE);
    try {
      JsonElement read = JsonParser.parseString(Files.readString(file));
      return read instanceof JsonObject verdict && !verdict.has("stoppedIn")
          ? Optional.of(new LastVerdict(verdict, isOlder(file, project, texts)))
          : Optional.empty();
    } catch (IOException | UncheckedIOException | JsonParseException e) {
      return Optional.empty();
    }
  }

  private static boolean isOlder(Path file, ProjectFolder project, OpenTexts texts)
      throws IOException {
    for (OpenText each : texts.all()) {
      if (each.path().startsWith(project.folder())
          && !each.path().startsWith(project.defaultOutput())
          && !isSaved(each)) {
        return true;
      }
    }
    FileTime written = Files.getLastModifiedTime(file);
    try (Stream<Path> all =
        Files.find(
            project.folder(),
            DEEPEST,
            (each, is) -> is.isRegularFile() && is.lastModifiedTime().compareTo(written) > 0)) {
      return all.anyMatch(each -> counts(each, project));
    }
  }

  private static boolean isSaved(OpenText text) throws IOException {
    return Files.exists(text.path())
        && SourceText.of("", Files.readString(text.path())).text().equals(text.withoutMark());
  }

  /** Returns whether a file may belong to the project: it is no result, and not hidden. */
  private static boolean counts(Path file, ProjectFolder project) {
    if (file.startsWith(project.defaultOutput())) {
      return false;
    }
    for (Path part : project.folder().relativize(file)) {
      if (part.toString().startsWith(".") || part.toString().equals("__pycache__")) {
        return false;
      }
    }
    return true;
  }

  /** Returns the outcome of all scenarios, in words; empty if none is known. */
  Optional<String> ofAll() {
    List<JsonObject> scenarios = objects(verdict, "scenarios");
    long passed = scenarios.stream().filter(LastVerdict::hasPassed).count();
    return scenarios.isEmpty()
        ? Optional.empty()
        : Optional.of(
            aged(
                (is(verdict, "passed") ? "Passed" : "Not passed")
                    + ": %d of %d scenarios".formatted(passed, scenarios.size())));
  }

  /** Returns the outcome of a scenario, in words, with the smallest margins. */
  Optional<String> of(String scenario) {
    return objects(verdict, "scenarios").stream()
        .filter(each -> text(each, "name").equals(scenario))
        .findFirst()
        .map(each -> aged(outcome(each)));
  }

  private static String outcome(JsonObject scenario) {
    List<JsonObject> criteria = objects(scenario, "criteria");
    if (hasPassed(scenario)) {
      String margins = smallestMargins(criteria);
      return margins.isEmpty() ? "Passed" : "Passed, smallest margin " + margins;
    }
    String missed =
        criteria.stream()
            .filter(each -> is(each, "tested") == is(scenario, "tested") && !hasPassed(each))
            .map(each -> text(each, "text") + marginOf(each))
            .findFirst()
            .map(each -> ": " + each)
            .orElse("");
    return (is(scenario, "tested") ? "Failed" : "Not tested") + missed;
  }

  private static boolean hasPassed(JsonObject outcome) {
    return is(outcome, "tested") && is(outcome, "passed");
  }

  private static String marginOf(JsonObject criterion) {
    String margin = smallestMargins(List.of(criterion));
    return margin.isEmpty() ? "" : ", margin " + margin;
  }

  /** Returns the smallest margin in each unit: those of different units cannot be compared. */
  private static String smallestMargins(List<JsonObject> criteria) {
    Map<String, BigDecimal> smallest = new TreeMap<>();
    for (JsonObject each : criteria) {
      if (each.get("margin") instanceof JsonObject margin
          && margin.get("value") instanceof JsonPrimitive value
          && value.isNumber()) {
        smallest.merge(text(margin, "unit"), value.getAsBigDecimal(), BigDecimal::min);
      }
    }
    return smallest.entrySet().stream()
        .map(
            each ->
                rounded(each.getValue()) + (each.getKey().equals("1") ? "" : " " + each.getKey()))
        .collect(Collectors.joining(", "));
  }

  private static String rounded(BigDecimal value) {
    return value.round(DIGITS).stripTrailingZeros().toPlainString();
  }

  private String aged(String outcome) {
    return isOlder ? outcome + " (older: files have changed since)" : outcome;
  }

  private static boolean is(JsonObject object, String name) {
    return object.get(name) instanceof JsonPrimitive value && value.getAsBoolean();
  }

  private static String text(JsonObject object, String name) {
    return object.get(name) instanceof JsonPrimitive value ? value.getAsString() : "";
  }

  private static List<JsonObject> objects(JsonObject object, String name) {
    List<JsonObject> objects = new ArrayList<>();
    if (object.get(name) instanceof JsonArray array) {
      array.forEach(
          each -> {
            if (each instanceof JsonObject inside) {
              objects.add(inside);
            }
          });
    }
    return objects;
  }
}
