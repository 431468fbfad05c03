package dev.eventchain.pipeline.simulate;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.simulation.SimulationResult;
import dev.eventchain.simulation.verdict.Measurements;
import dev.eventchain.simulation.verdict.MessageFlow;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** A simulation's result for the report and {@code verdict.json}. */
public final class SimulationReport {

  /** Four decimals are enough for display, and keep the page small. */
  private static final double FINEST = 1e4;

  private static final double CENTIMETRES = 1e2;

  /** Property for nodes that were started elsewhere: describes their driver. */
  public static final String ATTACHED = "attached";

  private SimulationReport() {}

  /** Returns the simulation's part of the report. */
  static ObjectNode of(SimulationResult result) {
    ObjectNode report = JsonNodeFactory.instance.objectNode();
    report.put("confinement", result.host().confinement());
    report.put("python", result.host().python());
    report.put(
        "driver",
        String.format(
            Locale.ROOT,
            "%s, %.0f times real time",
            result.host().driver(),
            result.host().realTimeFactor()));
    if (result.host().attached()) {
      report.put(ATTACHED, result.host().driver());
    }
    ArrayNode scenarios = report.putArray("scenarios");
    result.verdicts().forEach(verdict -> scenarios.add(scenario(verdict)));
    if (!result.faults().isEmpty()) {
      report.set("faults", FaultReport.of(result));
    }
    nodes(report.putArray("nodes"), result.measurements().nodes());
    flow(report, result.measurements().flow());
    return report;
  }

  private static void nodes(ArrayNode nodes, List<Measurements.Node> measured) {
    for (Measurements.Node node : measured) {
      ObjectNode json = nodes.addObject().put("name", node.name());
      json.put("activations", node.activations());
      statistics(json, "period", node.period());
      statistics(json, "jitter", node.jitter());
      statistics(json, "executionTime", node.executionTime());
      statistics(json, "hostExecutionTime", node.hostExecutionTime());
      node.timesWorstCase().ifPresent(times -> json.put("timesWorstCase", times));
    }
  }

  /** Adds the measured values; omits missing ones. */
  private static void flow(ObjectNode report, MessageFlow flow) {
    ArrayNode hops = report.putArray("hops");
    for (MessageFlow.Hop hop : flow.hops()) {
      ObjectNode json = hops.addObject().put("topic", hop.topic());
      json.put("writer", hop.writer()).put("reader", hop.reader());
      statistics(json, "waiting", hop.waiting());
      statistics(json, "age", hop.age());
      hop.samples()
          .ifPresent(
              samples ->
                  json.putObject("samples")
                      .put("published", samples.published())
                      .put("read", samples.read())
                      .put("neverRead", samples.neverRead())
                      .put("unreadAtEnd", samples.unreadAtEnd()));
      hop.tooOld().ifPresent(exceeded -> exceeded(json.putObject("tooOld"), exceeded));
      hop.late().ifPresent(exceeded -> exceeded(json.putObject("late"), exceeded));
    }
    ArrayNode topics = report.putArray("topics");
    for (MessageFlow.Topic topic : flow.topics()) {
      ObjectNode json = topics.addObject().put("name", topic.name());
      topic.published().ifPresent(published -> json.put("published", published));
      topic.dropped().ifPresent(dropped -> json.put("dropped", dropped));
      topic.lost().ifPresent(lost -> json.put("lost", lost));
    }
  }

  private static void exceeded(ObjectNode json, MessageFlow.Exceeded exceeded) {
    json.put("limit", exceeded.limit()).put("times", exceeded.times()).put("of", exceeded.of());
  }

  /**
   * Returns the content of {@code verdict.json}: the same bytes for the same nodes and scenarios.
   *
   * @param outcomes the outcome of each requirement
   * @param found all findings about scenarios and measurements, suppressed ones apart; each
   *     scenario that did not pass has one
   */
  static byte[] verdict(
      EventChain chain, SimulationResult result, ArrayNode outcomes, Suppressions.Parted found) {
    List<Diagnostic> errors =
        found.remaining().stream().filter(each -> each.severity() == Severity.ERROR).toList();
    boolean accepted = result.passed() || !found.suppressed().isEmpty();
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    json.put("chain", chain.getName()).put("passed", accepted && errors.isEmpty());
    if (result.host().attached()) {
      json.put("driver", result.host().driver()); // otherwise the driver does not matter
    }
    if (!found.suppressed().isEmpty()) {
      json.put("suppressed", found.suppressed().size());
    }
    ArrayNode violated = JsonNodeFactory.instance.arrayNode();
    errors.stream()
        .filter(each -> !UntestedFindings.include(each))
        .map(Diagnostic::rule)
        .filter(rule -> !rule.isEmpty())
        .distinct()
        .forEach(violated::add);
    if (!violated.isEmpty()) {
      json.set("violated", violated);
    }
    json.set("requirements", outcomes);
    ArrayNode scenarios = json.putArray("scenarios");
    result.verdicts().forEach(verdict -> outcome(scenarios.addObject(), verdict));
    if (!result.faults().isEmpty()) {
      json.set("faults", FaultReport.of(result));
    }
    return pretty(json);
  }

  private static void outcome(ObjectNode json, ScenarioVerdict verdict) {
    json.put("name", verdict.scenario()).put("tested", verdict.tested());
    json.put("passed", verdict.passed());
    ArrayNode named = json.putArray("requirements");
    verdict.requirements().forEach(named::add);
    criteria(json, verdict);
  }

  /**
   * Returns the content of {@code verdict.json} without a verdict, because a run is in progress or
   * was stopped.
   *
   * @param stage the stage that is running or was stopped; empty if the run could not begin
   */
  public static byte[] noVerdict(String chain, Optional<Stage> stage) {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    json.put("chain", chain).put("passed", false);
    stage.ifPresent(stoppedIn -> json.put("stoppedIn", stoppedIn.id()));
    json.putArray("scenarios");
    return pretty(json);
  }

  /** Returns the name of the verdict's chain; empty if it cannot be read. */
  public static String chainOf(byte[] verdict) {
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
    figures(json, verdict);
    statistics(json, "latency", verdict.latency());
    series(json.putObject("series"), verdict);
    scene(json.putObject("scene"), verdict.series().scene());
    return json;
  }

  private static void figures(ObjectNode json, ScenarioVerdict verdict) {
    ArrayNode figures = json.putArray("measurements");
    for (ScenarioVerdict.Figure figure : verdict.figures()) {
      ObjectNode one = figures.addObject().put("name", figure.name()).put("unit", figure.unit());
      one.put("statistic", figure.statistic().name());
      one.put("value", rounded(figure.value())).put("time", rounded(figure.time()));
    }
  }

  private static void criteria(ObjectNode json, ScenarioVerdict verdict) {
    ArrayNode criteria = json.putArray("criteria");
    for (ScenarioVerdict.CriterionResult criterion : verdict.criteria()) {
      ObjectNode one = criteria.addObject().put("text", criterion.text());
      one.put("tested", criterion.tested()).put("passed", criterion.passed());
      one.put("measured", criterion.measured());
      criterion.margin().ifPresent(margin -> one.set("margin", margin(margin)));
      if (!criterion.limits().isEmpty()) {
        ArrayNode limits = one.putArray("limits");
        criterion
            .limits()
            .forEach(
                limit ->
                    limits.addObject().put("signal", limit.signal()).put("value", limit.value()));
      }
    }
  }

  private static ObjectNode margin(ScenarioVerdict.Margin margin) {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    if (Double.isFinite(margin.value())) {
      json.put("value", rounded(margin.value()));
    }
    return json.put("unit", margin.unit()).put("time", rounded(margin.time()));
  }

  private static String untested(ScenarioVerdict verdict) {
    return verdict.criteria().stream()
        .filter(criterion -> !criterion.tested())
        .findFirst()
        .map(criterion -> "not tested: " + criterion.measured())
        .orElse("not tested");
  }

  /** Returns the result in a sentence: missed criteria, or the number of satisfied ones. */
  private static String words(ScenarioVerdict verdict) {
    List<ScenarioVerdict.CriterionResult> criteria = verdict.criteria();
    String words =
        criteria.stream()
            .filter(criterion -> criterion.tested() && !criterion.passed())
            .map(criterion -> "not met: %s (%s)".formatted(criterion.text(), criterion.measured()))
            .findFirst()
            .orElse(
                criteria.size() == 1
                    ? "1 criterion holds"
                    : "%d criteria hold".formatted(criteria.size()));
    return verdict
        .latency()
        .map(latency -> words + format(", latency up to %.0f ms", latency.maximum()))
        .orElse(words);
  }

  private static String format(String pattern, double value) {
    return String.format(Locale.ROOT, pattern, value);
  }

  private static void series(ObjectNode json, ScenarioVerdict verdict) {
    column(json.putArray("time"), verdict.series().time());
    ArrayNode signals = json.putArray("signals");
    for (ScenarioVerdict.Curve curve : verdict.series().curves()) {
      ObjectNode signal = signals.addObject().put("name", curve.name()).put("unit", curve.unit());
      if (!curve.absence().isEmpty()) {
        signal.put("absent", curve.absence());
      }
      column(signal.putArray("values"), curve.values());
    }
  }

  /** Adds the positions of all objects for the top view, in centimetres: finer than a pixel. */
  private static void scene(ObjectNode json, ScenarioVerdict.Scene scene) {
    json.put("curvature", scene.curvature()).put("lane_width", scene.laneWidth());
    json.put("wall_distance", scene.wallDistance());
    mover(json.putObject("ego"), scene.ego());
    ArrayNode others = json.putArray("others");
    scene.others().forEach(other -> mover(others.addObject(), other));
    ArrayNode scans = json.putArray("scans");
    for (ScenarioVerdict.Scan scan : scene.scans()) {
      ObjectNode points = scans.addObject().put("time", scan.time());
      column(points.putArray("x"), scan.x(), CENTIMETRES);
      column(points.putArray("y"), scan.y(), CENTIMETRES);
    }
  }

  private static void mover(ObjectNode json, ScenarioVerdict.Mover mover) {
    json.put("name", mover.name()).put("length", mover.length()).put("width", mover.width());
    column(json.putArray("x"), mover.x(), CENTIMETRES);
    column(json.putArray("y"), mover.y(), CENTIMETRES);
    column(json.putArray("heading"), mover.heading(), FINEST);
  }

  private static void column(ArrayNode json, List<Double> values) {
    column(json, values, FINEST);
  }

  /** Adds values, rounded to {@code 1 / parts}. */
  private static void column(ArrayNode json, List<Double> values, double parts) {
    for (double value : values) {
      if (Double.isFinite(value)) {
        json.add(Math.round(value * parts) / parts);
      } else {
        json.addNull();
      }
    }
  }

  private static double rounded(double value) {
    return Math.round(value * FINEST) / FINEST;
  }

  private static void statistics(
      ObjectNode json, String name, Optional<Measurements.Statistics> statistics) {
    statistics.ifPresent(
        s ->
            json.putObject(name)
                .put("minimum", s.minimum())
                .put("mean", s.mean())
                .put("median", s.median())
                .put("percentile99", s.percentile99())
                .put("maximum", s.maximum())
                .put("count", s.count()));
  }
}
