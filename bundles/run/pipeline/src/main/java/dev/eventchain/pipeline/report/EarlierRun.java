package dev.eventchain.pipeline.report;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/** Measurements of an earlier run, which the report compares with this one's. Immutable. */
public final class EarlierRun {

  private final Map<String, JsonNode> scenarios;

  private EarlierRun(Map<String, JsonNode> scenarios) {
    this.scenarios = scenarios;
  }

  /**
   * Reads the measurements of a run.
   *
   * @param file its {@code measurements.json}, or the folder of its results; empty for no
   *     comparison
   * @throws DiagnosticException (INPUT) {@code project.comparison.unreadable}
   */
  public static EarlierRun read(Optional<Path> file) {
    Map<String, JsonNode> scenarios = new LinkedHashMap<>();
    file.ifPresent(
        given -> {
          Path path = Files.isDirectory(given) ? given.resolve("measurements.json") : given;
          for (JsonNode scenario : json(path).path("scenarios")) {
            scenarios.put(scenario.path("name").asText(), scenario);
          }
          if (scenarios.isEmpty()) {
            throw unreadable(path, "There are no scenarios in it.");
          }
        });
    return new EarlierRun(scenarios);
  }

  private static JsonNode json(Path path) {
    try {
      return new JsonMapper().readTree(Files.readAllBytes(path));
    } catch (IOException e) {
      throw unreadable(
          path,
          Files.exists(path)
              ? "It cannot be read as the measurements of a run."
              : "There is no such file.");
    }
  }

  private static DiagnosticException unreadable(Path path, String why) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.error("project.comparison.unreadable", why, SourceLocation.of(path))
            .withHint("Name the measurements.json of another run, or the folder that holds it."));
  }

  /** Returns the scenarios of this run, each with its earlier measurements, if any. */
  ArrayNode beside(JsonNode now) {
    ArrayNode all = JsonNodeFactory.instance.arrayNode();
    for (JsonNode scenario : now) {
      JsonNode before = scenarios.get(scenario.path("name").asText());
      if (before == null || !scenario.isObject()) {
        all.add(scenario);
        continue;
      }
      ObjectNode both = scenario.deepCopy();
      ObjectNode earlier = both.putObject("before");
      for (String part : new String[] {"tested", "passed", "criteria", "series"}) {
        earlier.set(part, before.path(part));
      }
      all.add(both);
    }
    return all;
  }
}
