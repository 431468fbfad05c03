package dev.eventchain.pipeline.simulate;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.pipeline.results.DelayedScenario;
import dev.eventchain.pipeline.run.Stage;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.simulation.CaseSimulation;
import dev.eventchain.simulation.SimulationResult;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.CaseResult;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import dev.eventchain.simulation.verdict.ScenarioVerdict.CriterionResult;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.Collectors;

/**
 * Margins of scenarios that are left if the latency of the chain is at its bound: each is driven
 * again with messages that come later by what the bound is above the measured time.
 */
final class LatencyMargins {

  private static final double MILLISECOND = 1e6;
  private static final double FINEST = 1e4;
  private static final double KILOMETRES_PER_HOUR = 3.6;
  private static final String SPEED = "ego.speed";
  private static final String FAILED = CaseResult.Label.FAILED.name().toLowerCase(Locale.ROOT);

  /** A scenario with its result so far. */
  private record Reserve(Scenario scenario, ScenarioVerdict verdict, long delay) {}

  private LatencyMargins() {}

  /**
   * Drives the scenarios again in which a latency of the chain was measured below its bound.
   *
   * @param bound in ns
   */
  static List<DelayedScenario> of(
      RunContext run, List<Scenario> scenarios, SimulationResult result, long bound) {
    Map<String, Scenario> byName =
        scenarios.stream()
            .collect(Collectors.toMap(Scenario::name, Function.identity(), (one, other) -> one));
    List<Reserve> reserves = new ArrayList<>();
    for (ScenarioVerdict verdict : result.verdicts()) {
      long measured =
          verdict.latency().map(it -> Math.round(it.maximum() * MILLISECOND)).orElse(bound);
      if (verdict.tested() && measured < bound && byName.containsKey(verdict.scenario())) {
        reserves.add(new Reserve(byName.get(verdict.scenario()), verdict, bound - measured));
      }
    }
    Map<Integer, CaseResult> delayed = drive(run, reserves);
    List<DelayedScenario> found = new ArrayList<>();
    delayed.forEach((number, outcome) -> found.add(delayed(reserves.get(number), outcome)));
    return found;
  }

  /** Returns a finding for each scenario that passes as measured, and ends with an impact later. */
  static List<Diagnostic> findings(
      List<DelayedScenario> delayed, List<Scenario> scenarios, SimulationResult result) {
    Set<String> passed =
        result.verdicts().stream()
            .filter(ScenarioVerdict::passed)
            .map(ScenarioVerdict::scenario)
            .collect(Collectors.toSet());
    List<Diagnostic> found = new ArrayList<>();
    for (DelayedScenario each : delayed) {
      boolean failed = each.outcome().equals(FAILED) && passed.contains(each.scenario());
      if (failed && each.impact().isPresent()) {
        found.add(finding(each, each.impact().getAsDouble(), scenarios));
      }
    }
    return found;
  }

  private static Diagnostic finding(
      DelayedScenario delayed, double impact, List<Scenario> scenarios) {
    SourceLocation place =
        scenarios.stream()
            .filter(scenario -> scenario.name().equals(delayed.scenario()))
            .findFirst()
            .map(Scenario::location)
            .orElse(SourceLocation.NONE);
    return Diagnostic.of(
            SimulateRules.SIMULATION_LATENCY_AT_BOUND,
            String.format(
                Locale.ROOT,
                "Scenario %s passes with a latency of %.0f ms, as measured; with the %.0f ms that other phases of the timers make possible, %.1f m later at %.0f km/h, it ends with an impact at %.1f km/h.",
                delayed.scenario(),
                delayed.longest(),
                delayed.longest() + delayed.delay(),
                delayed.metres(),
                delayed.speed() * KILOMETRES_PER_HOUR,
                impact * KILOMETRES_PER_HOUR),
            place)
        .withHint(
            "Execute components of the chain more often or faster, or let the software act earlier; latency-bounds.json says where the time goes.");
  }

  private static Map<Integer, CaseResult> drive(RunContext run, List<Reserve> reserves) {
    Map<Integer, CaseResult> results = new TreeMap<>();
    if (reserves.isEmpty()) {
      return results;
    }
    Bench bench = run.chain().bench();
    int processes = Runtime.getRuntime().availableProcessors();
    List<Scenario> scenarios = reserves.stream().map(Reserve::scenario).toList();
    try {
      new CaseSimulation(
              SimulateStage.request(run, scenarios).with(it -> it.withProcesses(processes)),
              run.python(Stage.SIMULATE))
          .run(
              reserves.size(),
              number ->
                  new CaseSimulation.Case(
                      scenarios.get(number), bench.later(reserves.get(number).delay())),
              results::put);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new DiagnosticException(
          DiagnosticException.Reason.FINDINGS,
          Diagnostic.of(
              SimulateRules.SIMULATION_INTERRUPTED,
              "The simulation with latencies at their bounds was interrupted.",
              SourceLocation.NONE));
    }
    return results;
  }

  private static DelayedScenario delayed(Reserve reserve, CaseResult outcome) {
    double speed = speed(reserve.verdict());
    return new DelayedScenario(
        reserve.scenario().name(),
        rounded(reserve.verdict().latency().orElseThrow().maximum()),
        rounded(reserve.delay() / MILLISECOND),
        rounded(speed),
        rounded(speed * reserve.delay() / MILLISECOND / 1e3),
        outcome.label().name().toLowerCase(Locale.ROOT),
        outcome.reason(),
        outcome.impactSpeed().isPresent()
            ? OptionalDouble.of(rounded(outcome.impactSpeed().getAsDouble()))
            : OptionalDouble.empty(),
        margins(reserve.verdict(), outcome));
  }

  private static double speed(ScenarioVerdict verdict) {
    return verdict.series().curves().stream()
        .filter(curve -> curve.name().equals(SPEED))
        .flatMap(curve -> curve.values().stream())
        .filter(Double::isFinite)
        .mapToDouble(Double::doubleValue)
        .max()
        .orElse(0);
  }

  private static List<DelayedScenario.Margin> margins(ScenarioVerdict verdict, CaseResult after) {
    List<DelayedScenario.Margin> margins = new ArrayList<>();
    for (CriterionResult each : verdict.criteria()) {
      each.margin()
          .filter(margin -> Double.isFinite(margin.value()))
          .ifPresent(
              margin ->
                  margins.add(
                      new DelayedScenario.Margin(
                          each.text(),
                          margin.unit(),
                          rounded(margin.value()),
                          margin(after, each.text(), margin.unit()))));
    }
    return margins;
  }

  /** Returns the margin of a criterion, if it is of the same kind as before an impact. */
  private static OptionalDouble margin(CaseResult result, String criterion, String unit) {
    return result.criteria().stream()
        .filter(it -> it.name().equals(criterion) && it.unit().equals(unit))
        .flatMapToDouble(it -> it.margin().stream())
        .filter(Double::isFinite)
        .map(LatencyMargins::rounded)
        .findFirst();
  }

  private static double rounded(double value) {
    return Math.round(value * FINEST) / FINEST;
  }
}
