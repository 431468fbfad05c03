package dev.eventchain.simulation;

import dev.eventchain.metamodel.eventchain.LatencyConstraint;
import dev.eventchain.metamodel.eventchain.LatencyKind;
import dev.eventchain.simulation.ScenarioRunner.Run;
import dev.eventchain.simulation.ScenarioVerdict.CriterionResult;
import java.util.List;
import java.util.Optional;

/** Judges what happened in a scenario. */
final class ScenarioJudge {

  private static final double MILLISECOND = 1e6;

  private final NodeSetup setup;
  private final Signal.Source signals = new WorldSignals();

  ScenarioJudge(NodeSetup setup) {
    this.setup = setup;
  }

  /**
   * Judges a scenario.
   *
   * @param worked whether every component worked
   */
  ScenarioVerdict verdict(Run run, boolean worked) {
    Scenario scenario = run.scenario();
    Trace trace = run.trace();
    List<CriterionResult> criteria =
        scenario.criteria().stream().map(each -> judge(each, trace, worked)).toList();
    boolean passed = criteria.stream().allMatch(CriterionResult::passed);
    boolean failed = criteria.stream().anyMatch(each -> each.tested() && !each.passed());
    boolean tested = failed || criteria.stream().allMatch(CriterionResult::tested);
    return new ScenarioVerdict(
        scenario.name(),
        scenario.title(),
        scenario.requirements(),
        tested,
        passed,
        criteria,
        WhatHappened.figures(trace, signals),
        latency(run.log()),
        setup.latencyConstraints().stream().map(each -> latency(run.log(), each)).toList(),
        WhatHappened.series(trace, signals));
  }

  private static CriterionResult judge(Expectation criterion, Trace trace, boolean worked) {
    Criterion.Outcome outcome =
        worked ? criterion.judge(trace) : Criterion.Outcome.untested("not all components worked");
    return new CriterionResult(
        criterion.text(),
        outcome.tested(),
        outcome.passed(),
        outcome.detail(),
        outcome.margin(),
        criterion.limits(),
        criterion.location());
  }

  private static Optional<Measurements.Statistics> latency(RunLog log) {
    return statistics(
        ChainLatency.reactions(log, CarlaBridge.LIDAR.name(), CarlaBridge.CONTROL.name()));
  }

  /** What was measured of a constraint; an incomplete one is a finding of the model. */
  private static Optional<Measurements.Statistics> latency(
      RunLog log, LatencyConstraint constraint) {
    if (constraint.getFirst() == null || constraint.getLast() == null) {
      return Optional.empty();
    }
    return statistics(
        ChainLatency.between(
            log,
            constraint.getFirst().getName(),
            constraint.getLast().getName(),
            constraint.getKind() == LatencyKind.DATA_AGE));
  }

  private static Optional<Measurements.Statistics> statistics(List<Long> nanoseconds) {
    return Measurements.Statistics.of(
        nanoseconds.stream().mapToDouble(value -> value / MILLISECOND).toArray());
  }
}
