package dev.eventchain.pipeline;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.metamodel.eventchain.EventChain;
import dev.eventchain.simulation.Measurements;
import dev.eventchain.simulation.ScenarioVerdict;
import dev.eventchain.simulation.ScenarioVerdict.Moment;
import dev.eventchain.simulation.SimulationResult;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.ToDoubleFunction;

/** A simulation's result as the report and {@code verdict.json} show it. */
final class SimulationReport {

  private static final double KILOMETRES_PER_HOUR = 3.6;

  private SimulationReport() {}

  /** What the simulation adds to the report. */
  static ObjectNode of(SimulationResult result) {
    ObjectNode report = JsonNodeFactory.instance.objectNode();
    report.put("confinement", result.host().confinement());
    report.put("python", result.host().python());
    report.put(
        "driver",
        String.format(
            Locale.ROOT, "lock-step, %.0f times real time", result.host().realTimeFactor()));
    ArrayNode scenarios = report.putArray("scenarios");
    result.verdicts().forEach(verdict -> scenarios.add(scenario(verdict)));
    ArrayNode nodes = report.putArray("nodes");
    for (Measurements.Node node : result.measurements().nodes()) {
      ObjectNode json = nodes.addObject().put("name", node.name());
      json.put("activations", node.activations());
      statistics(json, "period", node.period());
      statistics(json, "jitter", node.jitter());
      statistics(json, "executionTime", node.executionTime());
      statistics(json, "hostExecutionTime", node.hostExecutionTime());
      node.timesWorstCase().ifPresent(times -> json.put("timesWorstCase", times));
    }
    return report;
  }

  /**
   * The content of {@code verdict.json}: the same bytes for the same nodes and scenarios.
   *
   * @param errors what was found wanting, of the scenarios and of what was measured
   */
  static byte[] verdict(EventChain chain, SimulationResult result, List<Diagnostic> errors) {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    json.put("chain", chain.getName()).put("passed", result.passed() && errors.isEmpty());
    ArrayNode violated = JsonNodeFactory.instance.arrayNode();
    errors.stream()
        .map(Diagnostic::rule)
        .filter(rule -> !rule.isEmpty())
        .distinct()
        .forEach(violated::add);
    if (!violated.isEmpty()) {
      json.set("violated", violated);
    }
    ArrayNode scenarios = json.putArray("scenarios");
    for (ScenarioVerdict verdict : result.verdicts()) {
      ObjectNode scenario = scenarios.addObject();
      scenario.put("name", verdict.scenario()).put("tested", verdict.tested());
      scenario.put("passed", verdict.passed());
      ArrayNode requirements = scenario.putArray("requirements");
      verdict.requirements().forEach(requirements::add);
      criteria(scenario, verdict);
    }
    return pretty(json);
  }

  /**
   * The content of {@code verdict.json} where there is none: a run is at work, or was stopped.
   *
   * @param stage where it is or was stopped; none if it could not be begun
   */
  static byte[] noVerdict(String chain, Optional<Stage> stage) {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    json.put("chain", chain).put("passed", false);
    stage.ifPresent(stoppedIn -> json.put("stoppedIn", stoppedIn.id()));
    json.putArray("scenarios");
    return pretty(json);
  }

  /** The name of the chain that a verdict is about; empty if it cannot be read. */
  static String chainOf(byte[] verdict) {
    try {
      return new ObjectMapper().readTree(verdict).path("chain").asText();
    } catch (IOException e) {
      return "";
    }
  }

  private static byte[] pretty(ObjectNode json) {
    DefaultIndenter indenter = new DefaultIndenter("  ", "\n");
    DefaultPrettyPrinter printer =
        new DefaultPrettyPrinter().withObjectIndenter(indenter).withArrayIndenter(indenter);
    try {
      String text = new ObjectMapper().writer(printer).writeValueAsString(json) + "\n";
      return text.getBytes(StandardCharsets.UTF_8);
    } catch (JsonProcessingException e) {
      throw new IllegalStateException("a verdict is plain data", e);
    }
  }

  private static ObjectNode scenario(ScenarioVerdict verdict) {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    json.put("name", verdict.scenario()).put("title", verdict.title());
    json.put("tested", verdict.tested()).put("passed", verdict.passed());
    json.put("text", verdict.tested() ? words(verdict) : untested(verdict));
    ArrayNode requirements = json.putArray("requirements");
    verdict.requirements().forEach(requirements::add);
    criteria(json, verdict);
    number(json, "minimalGap", verdict.minimalGap());
    number(json, "impactSpeed", verdict.impactSpeed());
    number(json, "timeToCollisionAtFirstBraking", verdict.timeToCollisionAtFirstBraking());
    statistics(json, "latency", verdict.latency());
    ObjectNode series = json.putObject("series");
    series(series, "time", verdict, Moment::time);
    series(series, "egoSpeed", verdict, Moment::egoSpeed);
    series(series, "gap", verdict, Moment::gap);
    series(series, "timeToCollision", verdict, Moment::timeToCollision);
    series(series, "brake", verdict, Moment::brake);
    series(series, "deceleration", verdict, Moment::deceleration);
    return json;
  }

  private static void criteria(ObjectNode json, ScenarioVerdict verdict) {
    ArrayNode criteria = json.putArray("criteria");
    for (ScenarioVerdict.CriterionResult criterion : verdict.criteria()) {
      criteria
          .addObject()
          .put("text", criterion.text())
          .put("tested", criterion.tested())
          .put("passed", criterion.passed())
          .put("measured", criterion.measured());
    }
  }

  private static String untested(ScenarioVerdict verdict) {
    return verdict.criteria().stream()
        .filter(criterion -> !criterion.tested())
        .findFirst()
        .map(criterion -> "not tested: " + criterion.measured())
        .orElse("not tested");
  }

  /** What happened, in a sentence. */
  private static String words(ScenarioVerdict verdict) {
    StringBuilder words = new StringBuilder();
    if (verdict.impactSpeed().isPresent()) {
      words.append(
          format("impact at %.1f km/h", verdict.impactSpeed().getAsDouble() * KILOMETRES_PER_HOUR));
    } else if (verdict.minimalGap().isPresent()) {
      words.append(format("minimal gap %.2f m", verdict.minimalGap().getAsDouble()));
    } else {
      words.append("nothing in the own lane");
    }
    if (verdict.timeToCollisionAtFirstBraking().isPresent()) {
      words.append(
          format(", brakes at TTC %.2f s", verdict.timeToCollisionAtFirstBraking().getAsDouble()));
    } else {
      words.append(verdict.firstBraking().isPresent() ? ", brakes" : ", no braking");
    }
    verdict
        .latency()
        .ifPresent(latency -> words.append(format(", latency up to %.0f ms", latency.maximum())));
    return words.toString();
  }

  private static String format(String pattern, double value) {
    return String.format(Locale.ROOT, pattern, value);
  }

  /** Four decimals show everything that can be seen, and keep the page small. */
  private static void series(
      ObjectNode series, String name, ScenarioVerdict verdict, ToDoubleFunction<Moment> value) {
    ArrayNode values = series.putArray(name);
    for (Moment moment : verdict.series()) {
      double number = value.applyAsDouble(moment);
      if (Double.isFinite(number)) {
        values.add(Math.round(number * 1e4) / 1e4);
      } else {
        values.addNull();
      }
    }
  }

  private static void number(ObjectNode json, String name, OptionalDouble value) {
    value.ifPresent(number -> json.put(name, number));
  }

  private static void statistics(
      ObjectNode json, String name, Optional<Measurements.Statistics> statistics) {
    statistics.ifPresent(
        s ->
            json.putObject(name)
                .put("minimum", s.minimum())
                .put("median", s.median())
                .put("percentile99", s.percentile99())
                .put("maximum", s.maximum())
                .put("count", s.count()));
  }
}
