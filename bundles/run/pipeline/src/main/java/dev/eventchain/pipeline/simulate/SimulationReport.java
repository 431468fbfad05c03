package dev.eventchain.pipeline.simulate;

import dev.eventchain.pipeline.results.BoundedLatency;
import dev.eventchain.pipeline.results.Criterion;
import dev.eventchain.pipeline.results.LoadedProcessor;
import dev.eventchain.pipeline.results.RequirementOutcome;
import dev.eventchain.pipeline.results.Simulated;
import dev.eventchain.pipeline.results.SimulatedScenario;
import dev.eventchain.pipeline.results.Statistics;
import dev.eventchain.pipeline.results.Validation;
import dev.eventchain.simulation.SimulationResult;
import dev.eventchain.simulation.verdict.Happened;
import dev.eventchain.simulation.verdict.Measurements;
import dev.eventchain.simulation.verdict.MessageFlow;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;

/** The simulation's part of the report. */
final class SimulationReport {

  private SimulationReport() {}

  /**
   * Returns the simulation's part of the report.
   *
   * @param latencies with their bounds
   * @param processors those to which components are mapped
   * @param untested the qualified names of untested constraints
   * @param outcomes the outcome of each requirement; empty in a simulation of some scenarios
   * @param strength why the strength of requirements was not measured, or the size of its sample;
   *     empty if all faults were driven
   * @param validation the results of the constraints on the measured model
   */
  static Simulated of(
      SimulationResult result,
      List<BoundedLatency> latencies,
      List<LoadedProcessor> processors,
      List<String> untested,
      List<RequirementOutcome> outcomes,
      Optional<String> strength,
      Validation validation) {
    SimulationResult.Host host = result.host();
    MessageFlow flow = result.measurements().flow();
    return new Simulated(
        host.confinement(),
        host.python(),
        String.format(
            Locale.ROOT, "%s, %.0f times real time", host.driver(), host.realTimeFactor()),
        attached(host),
        result.verdicts().stream().map(SimulationReport::scenario).toList(),
        FaultReport.of(result),
        result.measurements().nodes().stream().map(SimulationReport::node).toList(),
        flow.hops().stream().map(SimulationReport::hop).toList(),
        flow.topics().stream().map(SimulationReport::topic).toList(),
        latencies,
        processors,
        UnshownSignals.of(result).table(),
        untested,
        outcomes,
        strength,
        validation);
  }

  /** Returns the driver of nodes that were started elsewhere; otherwise it does not matter. */
  static Optional<String> attached(SimulationResult.Host host) {
    return host.attached() ? Optional.of(host.driver()) : Optional.empty();
  }

  private static Simulated.Node node(Measurements.Node node) {
    return new Simulated.Node(
        node.name(),
        node.activations(),
        statistics(node.period()),
        statistics(node.jitter()),
        statistics(node.executionTime()),
        statistics(node.hostExecutionTime()),
        node.timesWorstCase());
  }

  private static Simulated.Hop hop(MessageFlow.Hop hop) {
    return new Simulated.Hop(
        hop.topic(),
        hop.writer(),
        hop.reader(),
        statistics(hop.waiting()),
        statistics(hop.age()),
        hop.samples()
            .map(
                it ->
                    new Simulated.Samples(
                        it.published(), it.read(), it.neverRead(), it.unreadAtEnd())),
        hop.tooOld().map(SimulationReport::exceeded),
        hop.late().map(SimulationReport::exceeded));
  }

  private static Simulated.Exceeded exceeded(MessageFlow.Exceeded exceeded) {
    return new Simulated.Exceeded(exceeded.limit(), exceeded.times(), exceeded.of());
  }

  private static Simulated.Topic topic(MessageFlow.Topic topic) {
    return new Simulated.Topic(topic.name(), topic.published(), topic.dropped(), topic.lost());
  }

  private static SimulatedScenario scenario(ScenarioVerdict verdict) {
    return new SimulatedScenario(
        verdict.scenario(),
        verdict.title(),
        verdict.tested(),
        verdict.passed(),
        verdict.tested() ? words(verdict) : untested(verdict),
        verdict.requirements(),
        criteria(verdict),
        verdict.observed().stream().map(each -> criterion(verdict, each)).toList(),
        verdict.figures().stream().map(SimulationReport::figure).toList(),
        statistics(verdict.latency()),
        series(verdict.series()),
        scene(verdict.series().scene()),
        verdict.happened().stream().map(SimulationReport::happened).toList());
  }

  private static SimulatedScenario.Happened happened(Happened it) {
    String kind = it.kind().name().toLowerCase(Locale.ROOT);
    return new SimulatedScenario.Happened(it.name(), kind, it.start(), it.end());
  }

  private static SimulatedScenario.Figure figure(ScenarioVerdict.Figure figure) {
    return new SimulatedScenario.Figure(
        figure.name(),
        figure.unit(),
        figure.statistic().name(),
        Rounding.rounded(figure.value()),
        Rounding.rounded(figure.time()));
  }

  static List<Criterion> criteria(ScenarioVerdict verdict) {
    return verdict.criteria().stream().map(each -> criterion(verdict, each)).toList();
  }

  private static Criterion criterion(
      ScenarioVerdict verdict, ScenarioVerdict.CriterionResult criterion) {
    return new Criterion(
        criterion.text(),
        criterion.tested(),
        criterion.passed(),
        criterion.measured(),
        criterion.margin().map(SimulationReport::margin),
        criterion.judges().stream()
            .map(each -> new Criterion.Judged(each.requirement(), each.words()))
            .toList(),
        criterion.limits().stream()
            .map(limit -> new Criterion.Limit(limit.signal(), limit.value()))
            .toList(),
        Optional.of(criterion.requirements())
            .filter(named -> !named.equals(verdict.requirements())),
        criterion.cause().map(it -> true));
  }

  static Criterion.Margin margin(ScenarioVerdict.Margin margin) {
    return new Criterion.Margin(
        Double.isFinite(margin.value())
            ? OptionalDouble.of(Rounding.rounded(margin.value()))
            : OptionalDouble.empty(),
        margin.unit(),
        Rounding.rounded(margin.time()));
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
                    : String.format(Locale.ROOT, "%d criteria hold", criteria.size()));
    return verdict
        .latency()
        .map(latency -> words + format(", latency up to %.0f ms", latency.maximum()))
        .orElse(words);
  }

  private static String format(String pattern, double value) {
    return String.format(Locale.ROOT, pattern, value);
  }

  private static SimulatedScenario.Series series(ScenarioVerdict.Series series) {
    return new SimulatedScenario.Series(
        Rounding.rounded(series.time()),
        series.curves().stream()
            .map(
                curve ->
                    new SimulatedScenario.Signal(
                        curve.name(),
                        curve.unit(),
                        Optional.of(curve.absence()).filter(absence -> !absence.isEmpty()),
                        Rounding.rounded(curve.values()),
                        curve.names().stream()
                            .map(it -> new SimulatedScenario.Name(it.value(), it.name()))
                            .toList()))
            .toList());
  }

  /** Returns the positions of all objects for the top view, in centimetres: finer than a pixel. */
  private static SimulatedScenario.Scene scene(ScenarioVerdict.Scene scene) {
    return new SimulatedScenario.Scene(
        scene.curvature(),
        scene.laneWidth(),
        scene.wallDistance(),
        scene.lines().stream()
            .map(
                line ->
                    new SimulatedScenario.Line(
                        line.broken(),
                        Rounding.toCentimetres(line.x()),
                        Rounding.toCentimetres(line.y())))
            .toList(),
        mover(scene.ego()),
        scene.others().stream().map(SimulationReport::mover).toList(),
        scene.scans().stream()
            .map(
                scan ->
                    new SimulatedScenario.Scan(
                        scan.time(),
                        Rounding.toCentimetres(scan.x()),
                        Rounding.toCentimetres(scan.y())))
            .toList());
  }

  private static SimulatedScenario.Mover mover(ScenarioVerdict.Mover mover) {
    return new SimulatedScenario.Mover(
        mover.name(),
        mover.length(),
        mover.width(),
        Rounding.toCentimetres(mover.x()),
        Rounding.toCentimetres(mover.y()),
        Rounding.rounded(mover.heading()));
  }

  private static Optional<Statistics> statistics(Optional<Measurements.Statistics> statistics) {
    return statistics.map(
        it ->
            new Statistics(
                it.minimum(), it.mean(), it.median(), it.percentile99(), it.maximum(), it.count()));
  }
}
