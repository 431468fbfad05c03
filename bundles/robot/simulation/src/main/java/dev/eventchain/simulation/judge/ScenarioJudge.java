package dev.eventchain.simulation.judge;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.model.eventchain.LatencyConstraint;
import dev.eventchain.model.eventchain.LatencyKind;
import dev.eventchain.simulation.chain.SimulatedChain;
import dev.eventchain.simulation.formula.Outcome;
import dev.eventchain.simulation.formula.Signal;
import dev.eventchain.simulation.host.RunLog;
import dev.eventchain.simulation.measure.ChainLatency;
import dev.eventchain.simulation.measure.MessageFlows;
import dev.eventchain.simulation.run.ScenarioRun;
import dev.eventchain.simulation.scenario.Criterion;
import dev.eventchain.simulation.scenario.CriterionKind;
import dev.eventchain.simulation.scenario.Expectation;
import dev.eventchain.simulation.scenario.FormulaCriterion;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.Measurements;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import dev.eventchain.simulation.verdict.ScenarioVerdict.CriterionResult;
import dev.eventchain.simulation.world.Actuator;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.World;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/** Judges the run of a scenario. */
public final class ScenarioJudge {

  private static final double MILLISECOND = 1e6;

  /** Shortest run that says something, in ns. */
  private static final long SHORTEST = 1_000_000_000L;

  private final SimulatedChain chain;
  private final Evidence evidence;

  /**
   * Creates a judge of a simulation.
   *
   * @param runs all its runs without faults
   * @param complete false if the project has more scenarios than these
   */
  public ScenarioJudge(SimulatedChain chain, List<ScenarioRun> runs, boolean complete) {
    this.chain = chain;
    this.evidence = new Evidence(chain, runs, complete);
  }

  /**
   * Judges a scenario.
   *
   * @param worked true if every component worked, or its finding is accepted
   */
  public ScenarioVerdict verdict(ScenarioRun run, boolean worked) {
    Scenario scenario = run.scenario();
    Trace trace = run.trace();
    List<Signal> signals =
        chain.chainSignals().with(chain.bench().signals().reported(scenario.signals()));
    List<CriterionResult> criteria =
        applying(run)
            .filter(each -> !worked || !isUnasked(each, run))
            .map(each -> judge(each, run, worked))
            .toList();
    boolean passed = criteria.stream().allMatch(CriterionResult::passed);
    boolean failed = criteria.stream().anyMatch(each -> each.tested() && !each.passed());
    boolean tested = failed || criteria.stream().allMatch(CriterionResult::tested);
    return new ScenarioVerdict(
        scenario.name(),
        scenario.title(),
        judged(scenario, run, worked),
        worked,
        tested,
        passed,
        criteria,
        observed(run, worked),
        WhatHappened.figures(trace, signals),
        latency(run.log(), chain),
        chain.latencyConstraints().stream().map(each -> latency(run, each)).toList(),
        MessageFlows.of(List.of(run), chain),
        WhatHappened.series(scenario.situation(), trace, signals),
        run.samples(),
        WhatHappened.happened(scenario, trace));
  }

  /**
   * Judges the applicable criteria of the run's scenario, as for {@link #verdict}; those that are
   * not asked are among them, as untested.
   */
  public List<CriterionResult> criteria(ScenarioRun run, boolean worked) {
    return applying(run).map(each -> judge(each, run, worked)).toList();
  }

  private Stream<Expectation> applying(ScenarioRun run) {
    return run.scenario().criteria().stream().filter(this::applies);
  }

  /** Returns the scenario's requirements without those of which the run asks no criterion. */
  private List<String> judged(Scenario scenario, ScenarioRun run, boolean worked) {
    Set<String> unasked = new HashSet<>();
    Set<String> asked = new HashSet<>();
    for (Expectation each : scenario.criteria()) {
      if (!each.isOfEveryScenario()) {
        (worked && isUnasked(each, run) ? unasked : asked).addAll(each.requirements());
      }
    }
    unasked.removeAll(asked);
    return scenario.requirements().stream().filter(id -> !unasked.contains(id)).toList();
  }

  /** Returns what is only observed, and the criteria that a run does not ask. */
  private List<CriterionResult> observed(ScenarioRun run, boolean worked) {
    Scenario scenario = run.scenario();
    return worked
        ? Stream.concat(
                scenario.observed().stream(),
                scenario.criteria().stream().filter(each -> isUnasked(each, run)))
            .map(each -> result(scenario, each, each.judge(run.trace())))
            .toList()
        : List.of();
  }

  /**
   * Returns whether a criterion is optional, and the software did not come to its premise. Software
   * that sends nothing on a topic that it is to write has not avoided the premise. Neither has
   * software that came to it in a run that ended before the criterion was decided.
   */
  public boolean isUnasked(Expectation criterion, ScenarioRun run) {
    return run.scenario().isOptional(criterion)
        && !run.isOverrun()
        && !run.trace().isCut()
        && isLeftAside(criterion, run.trace())
        && criterion.signals().stream().noneMatch(signal -> isSilent(signal, run.trace()));
  }

  private static boolean isLeftAside(Expectation criterion, Trace trace) {
    Outcome outcome = criterion.judge(trace);
    return !outcome.tested() && !(outcome.undecided() && criterion.cameToPremise(trace));
  }

  /**
   * Returns whether a run leaves open if a criterion holds: it ended too soon, or software sent
   * nothing on the topics that decide. A premise that never came true leaves nothing open.
   */
  public boolean isOpen(Expectation criterion, ScenarioRun run) {
    Outcome outcome = withoutEvidence(criterion, run);
    return outcome.undecided()
        || outcome.missing().stream().anyMatch(chain.topicsWritten()::contains);
  }

  /**
   * Returns the written values that are outside the ranges of their signals, in words: no scenario
   * shows the effect of such values on a vehicle.
   */
  public List<String> outOfRange(ScenarioRun run) {
    return run.trace().outside().stream()
        .filter(value -> chain.topicsWritten().contains(value.topic()))
        .map(value -> "a value of " + value.topic() + " that its signal never has")
        .toList();
  }

  private boolean isSilent(Signal signal, Trace trace) {
    return signal.topic().filter(chain.topicsWritten()::contains).isPresent()
        && signal.absence().apply(trace).isPresent();
  }

  /**
   * Judges the applicable criteria of the run's scenario as {@link #criteria} does, except that a
   * criterion passes also where that is no evidence for the software.
   */
  public List<CriterionResult> criteriaWithoutEvidence(ScenarioRun run) {
    return applying(run)
        .map(each -> result(run.scenario(), each, withoutEvidence(each, run)))
        .toList();
  }

  /** Returns whether a criterion was not tested because nothing was ahead. */
  public boolean isOfNothingAhead(Expectation criterion, ScenarioRun run) {
    return withoutEvidence(criterion, run).lack() == Outcome.Lack.NOTHING_AHEAD;
  }

  /**
   * Returns whether a criterion applies; those of every scenario need software that commands the
   * vehicle.
   */
  private boolean applies(Expectation expectation) {
    if (!(expectation instanceof Criterion criterion) || !criterion.kind().always()) {
      return true;
    }
    return criterion.kind() == CriterionKind.BRAKE_NORMALIZED
        ? chain.drives(Actuator.BRAKE)
        : !chain.commands().isEmpty();
  }

  private CriterionResult judge(Expectation criterion, ScenarioRun run, boolean worked) {
    if (!worked && !run.isOverrun()) {
      return result(run.scenario(), criterion, Outcome.untested("not all components worked"));
    }
    Outcome outcome = evidence.withAvoided(criterion, run, withoutEvidence(criterion, run));
    CriterionResult result =
        result(
            run.scenario(),
            criterion,
            outcome.passed() ? evidence.lackOf(criterion, run).orElse(outcome) : outcome);
    return result.withCause(
        ImpactCause.of(criterion, outcome, run, other -> withoutEvidence(other, run).failed())
            .or(() -> OpenEnd.cause(criterion, outcome, run)));
  }

  private Outcome withoutEvidence(Expectation criterion, ScenarioRun run) {
    if (run.isOverrun()) {
      return overrun(run);
    }
    if (needsBrake(criterion)) {
      return Outcome.untested("no component's output drives the brake");
    }
    if (criterion instanceof FormulaCriterion formula && !dependsOnSoftware(formula)) {
      return Outcome.untested("no component's output changes what it reads");
    }
    Optional<Outcome> other =
        criterion.isOfEveryScenario() ? Optional.empty() : TestConditions.broken(run);
    if (other.isPresent()) {
      return other.get();
    }
    Outcome outcome = criterion.judge(run.trace());
    return outcome.passed() || outcome.lack() == Outcome.Lack.NOTHING_AHEAD
        ? unlessItEndedEarly(criterion, run).orElse(outcome)
        : outcome;
  }

  /** Returns untested if too little happened for a criterion that was not violated. */
  private static Optional<Outcome> unlessItEndedEarly(Expectation criterion, ScenarioRun run) {
    Trace trace = run.trace();
    double end = World.seconds(trace.end().time());
    if (criterion.isOfEveryScenario()) {
      return Optional.empty();
    }
    if (!trace.neverBegun().isEmpty()) {
      return Optional.of(
          Outcome.untested("a maneuver never began: " + String.join(", ", trace.neverBegun())));
    }
    Optional<OpenEnd> open = OpenEnd.of(run).filter(it -> it.concerns(criterion));
    if (open.isPresent()) {
      return Optional.of(Outcome.undecided(open.get().words()));
    }
    if (criterion instanceof Criterion && trace.isCut()) {
      return Optional.of(
          Outcome.undecided(
              String.format(
                  Locale.ROOT,
                  "the run ended after %.2f s of %.2f s by an impact (%s)",
                  end,
                  run.scenario().duration(),
                  trace.impact())));
    }
    return trace.end().time() < SHORTEST && trace.impactSpeed().isEmpty()
        ? Optional.of(
            Outcome.untested(String.format(Locale.ROOT, "the run lasts %.2f s only", end)))
        : Optional.empty();
  }

  /**
   * Returns a finding {@code simulation.end.open} if a run ended too soon to tell whether there is
   * an impact, and a criterion is about one.
   */
  public static Optional<Diagnostic> openEnd(ScenarioRun run) {
    return OpenEnd.finding(run);
  }

  private static Outcome overrun(ScenarioRun run) {
    return Outcome.untested(
        String.format(
            Locale.ROOT, "this machine was %.0f ms behind the clock", run.overrun() / MILLISECOND));
  }

  static CriterionResult result(Scenario scenario, Expectation criterion, Outcome outcome) {
    return JudgedCriterion.of(scenario, criterion).result(outcome);
  }

  /** Returns whether the chain can influence a signal that a formula reads. */
  private boolean dependsOnSoftware(FormulaCriterion criterion) {
    return criterion.signals().stream()
        .flatMap(Signal::origins)
        .anyMatch(evidence.outputs()::dependsOnSoftware);
  }

  /**
   * Returns whether a named criterion needs the brake, or a speed, while no component drives it.
   */
  private boolean needsBrake(Expectation expectation) {
    return expectation instanceof Criterion criterion
        && !criterion.kind().always()
        && !chain.drives(Actuator.BRAKE, Actuator.ACCELERATION)
        && !(criterion.kind().isOfMotion() && chain.drives(Actuator.SPEED));
  }

  private static Optional<Measurements.Statistics> latency(RunLog log, SimulatedChain chain) {
    return statistics(ChainLatency.reactions(log, chain.entry(), chain.exit()));
  }

  /**
   * Returns the measured latency of a constraint; an incomplete constraint is a finding of the
   * model.
   */
  private Optional<ScenarioVerdict.Latency> latency(ScenarioRun run, LatencyConstraint constraint) {
    if (constraint.getFirst() == null || constraint.getLast() == null) {
      return Optional.empty();
    }
    List<ChainLatency.Latency> found =
        ChainLatency.between(
            run.log(),
            constraint.getFirst().getName(),
            constraint.getLast().getName(),
            constraint.getKind() == LatencyKind.DATA_AGE,
            topic -> chain.latencyBefore(topic, constraint));
    return statistics(found.stream().map(ChainLatency.Latency::time).toList())
        .map(statistics -> new ScenarioVerdict.Latency(statistics, slowest(found), 0));
  }

  /** Returns the parts of the longest latency; of equal ones, the first. */
  private static List<ScenarioVerdict.Part> slowest(List<ChainLatency.Latency> latencies) {
    ChainLatency.Latency slowest = latencies.get(0);
    for (ChainLatency.Latency each : latencies) {
      slowest = each.time() > slowest.time() ? each : slowest;
    }
    return slowest.parts().stream()
        .map(
            part ->
                new ScenarioVerdict.Part(
                    part.node(), part.waiting() / MILLISECOND, part.execution() / MILLISECOND))
        .toList();
  }

  private static Optional<Measurements.Statistics> statistics(List<Long> nanoseconds) {
    return Measurements.Statistics.of(
        nanoseconds.stream().mapToDouble(value -> value / MILLISECOND).toArray());
  }
}
