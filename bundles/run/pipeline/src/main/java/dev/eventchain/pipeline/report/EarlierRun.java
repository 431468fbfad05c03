package dev.eventchain.pipeline.report;

import com.fasterxml.jackson.annotation.JsonIgnoreProperties;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.pipeline.results.Criterion;
import dev.eventchain.pipeline.results.ResultJson;
import dev.eventchain.pipeline.results.SimulatedScenario;
import dev.eventchain.pipeline.simulate.SimulateStage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/** Measurements of an earlier run, which the report compares with this one's. Immutable. */
public final class EarlierRun {

  /** The measurements of a run, of which the report shows only these. */
  @JsonIgnoreProperties(ignoreUnknown = true)
  private record Measured(List<Scenario> scenarios) {}

  /** The measurements of a scenario. */
  @JsonIgnoreProperties(ignoreUnknown = true)
  private record Scenario(
      String name, boolean tested, boolean passed, JsonNode criteria, JsonNode series) {

    String word() {
      return !tested ? "not tested" : passed ? "passed" : "failed";
    }

    /** Returns whether a criterion had another outcome or other figures, or was not there. */
    boolean differs(Criterion now) {
      for (JsonNode each : criteria) {
        if (each.path("text").asText().equals(now.text())) {
          return each.path("passed").asBoolean() != now.passed()
              || each.path("tested").asBoolean() != now.tested()
              || !each.path("measured").asText().equals(now.measured());
        }
      }
      return true;
    }
  }

  private final Map<String, Scenario> scenarios;

  private EarlierRun(Map<String, Scenario> scenarios) {
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
    Map<String, Scenario> scenarios = new LinkedHashMap<>();
    file.ifPresent(
        given -> {
          Path path = Files.isDirectory(given) ? given.resolve(SimulateStage.MEASUREMENTS) : given;
          measured(path).scenarios().forEach(each -> scenarios.put(each.name(), each));
          if (scenarios.isEmpty()) {
            throw unreadable(path, "There are no scenarios in it.");
          }
        });
    return new EarlierRun(scenarios);
  }

  private static Measured measured(Path path) {
    try {
      return ResultJson.read(Files.readAllBytes(path), Measured.class);
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
        Diagnostic.of(ReportRules.COMPARISON_UNREADABLE, why, SourceLocation.of(path))
            .withHint("Name the measurements.json of another run, or the folder that holds it."));
  }

  /**
   * Returns what is different in a scenario, for the end of a line; empty without another run.
   *
   * @param now the scenario in this run
   */
  public String words(SimulatedScenario now) {
    if (scenarios.isEmpty()) {
      return "";
    }
    Scenario before = scenarios.get(now.name());
    if (before == null) {
      return "; was not there before";
    }
    if (before.tested() != now.tested() || before.passed() != now.passed()) {
      return "; " + before.word() + " before";
    }
    long other = now.criteria().stream().filter(before::differs).count();
    return other == 0
        ? "; as before"
        : String.format(
            Locale.ROOT, "; other figures in %d of %d criteria", other, now.criteria().size());
  }

  /** Returns the scenarios of this run, each with its earlier measurements, if any. */
  ArrayNode beside(List<SimulatedScenario> now) {
    ArrayNode all = JsonNodeFactory.instance.arrayNode();
    for (SimulatedScenario scenario : now) {
      ObjectNode both = (ObjectNode) ResultJson.tree(scenario);
      Scenario before = scenarios.get(scenario.name());
      if (before != null) {
        both.putObject("before")
            .put("tested", before.tested())
            .put("passed", before.passed())
            .<ObjectNode>set("criteria", before.criteria())
            .set("series", before.series());
      }
      all.add(both);
    }
    return all;
  }
}
