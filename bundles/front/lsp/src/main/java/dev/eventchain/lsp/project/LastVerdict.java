package dev.eventchain.lsp.project;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.lsp.text.OpenText;
import dev.eventchain.lsp.text.OpenTexts;
import dev.eventchain.lsp.text.ProtocolJson;
import dev.eventchain.project.ProjectFolder;
import dev.eventchain.project.ProjectLayout;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.math.BigDecimal;
import java.math.MathContext;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The verdict of a project's last run, and whether files have changed since. */
final class LastVerdict {

  private static final int DEEPEST = 8;
  private static final MathContext DIGITS = new MathContext(3);

  private final JsonNode verdict;
  private final boolean isOlder;

  private LastVerdict(JsonNode verdict, boolean isOlder) {
    this.verdict = verdict;
    this.isOlder = isOlder;
  }

  /** Reads the verdict; empty if there is none, or no run has got as far. */
  static Optional<LastVerdict> of(ProjectFolder project, OpenTexts texts) {
    Path file = project.defaultOutput().resolve(ProjectLayout.VERDICT);
    try {
      JsonNode verdict = ProtocolJson.read(Files.readString(file));
      return verdict.isObject() && !verdict.has("stoppedIn")
          ? Optional.of(new LastVerdict(verdict, isOlder(file, project, texts)))
          : Optional.empty();
    } catch (IOException | UncheckedIOException e) {
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
    List<JsonNode> scenarios = objects(verdict, "scenarios");
    long passed = scenarios.stream().filter(LastVerdict::hasPassed).count();
    return scenarios.isEmpty()
        ? Optional.empty()
        : Optional.of(
            aged(
                (is(verdict, "passed") ? "Passed" : "Not passed")
                    + String.format(
                        Locale.ROOT, ": %d of %d scenarios", passed, scenarios.size())));
  }

  /** Returns the outcome of a scenario, in words, with the smallest margins. */
  Optional<String> of(String scenario) {
    return objects(verdict, "scenarios").stream()
        .filter(each -> text(each, "name").equals(scenario))
        .findFirst()
        .map(each -> aged(outcome(each)));
  }

  private static String outcome(JsonNode scenario) {
    List<JsonNode> criteria = objects(scenario, "criteria");
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

  private static boolean hasPassed(JsonNode outcome) {
    return is(outcome, "tested") && is(outcome, "passed");
  }

  private static String marginOf(JsonNode criterion) {
    String margin = smallestMargins(List.of(criterion));
    return margin.isEmpty() ? "" : ", margin " + margin;
  }

  /** Returns the smallest margin in each unit: those of different units cannot be compared. */
  private static String smallestMargins(List<JsonNode> criteria) {
    Map<String, BigDecimal> smallest = new TreeMap<>();
    for (JsonNode each : criteria) {
      JsonNode margin = each.path("margin");
      if (margin.path("value").isNumber()) {
        smallest.merge(text(margin, "unit"), margin.get("value").decimalValue(), BigDecimal::min);
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

  private static boolean is(JsonNode object, String name) {
    return object.path(name).asBoolean();
  }

  private static String text(JsonNode object, String name) {
    return object.path(name).asText();
  }

  private static List<JsonNode> objects(JsonNode object, String name) {
    List<JsonNode> objects = new ArrayList<>();
    for (JsonNode each : object.path(name)) {
      if (each.isObject()) {
        objects.add(each);
      }
    }
    return objects;
  }
}
