package dev.eventchain.pipeline.simulate;

import dev.eventchain.contracts.ContractRule;
import dev.eventchain.contracts.latency.ChainTiming;
import dev.eventchain.contracts.latency.LatencyEstimate;
import dev.eventchain.contracts.latency.Stimuli;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.LatencyConstraint;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.pipeline.results.BoundedLatency;
import dev.eventchain.pipeline.results.DelayedScenario;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.simulation.SimulationResult;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.Measurements;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EObject;

/**
 * Upper bounds on the latencies that a simulation measured, with what its bench says of the
 * messages from outside.
 */
final class LatencyBounds {

  private static final double MILLISECOND = 1e6;

  /** Rounding of measured times, in ns. */
  private static final long TOLERANCE = 1_000;

  /**
   * A latency with its bound.
   *
   * @param constraint the constraint; empty for the latency of the whole chain
   * @param first the component where it begins
   * @param last the component where it ends
   * @param components what components alone make of it
   * @param estimate with the messages from outside
   * @param longest the longest time that was measured; empty if none was
   */
  record Bounded(
      Optional<LatencyConstraint> constraint,
      String first,
      String last,
      LatencyEstimate components,
      LatencyEstimate estimate,
      Optional<Longest> longest) {

    /** Returns whether the bound passes the maximum of the constraint. */
    private boolean passes(LatencyEstimate it) {
      double maximum = constraint.map(LatencyConstraint::getMaximum).orElse(0.0) * MILLISECOND;
      return maximum > 0 && it.bound().orElse(it.known()) > maximum;
    }

    private String name() {
      return constraint.map(it -> "'" + it.getName() + "'").orElse("The latency of the chain");
    }
  }

  /**
   * The longest measured time.
   *
   * @param time of the messages, without the value latency of components, in ns
   * @param parts what it consists of, if that is known
   */
  record Longest(String scenario, long time, List<ScenarioVerdict.Part> parts) {

    private static Longest of(ScenarioVerdict verdict, ScenarioVerdict.Latency latency) {
      double time = latency.statistics().maximum() - latency.values();
      // Parts have the value latency in them, which no bound covers.
      List<ScenarioVerdict.Part> parts = latency.values() > 0 ? List.of() : latency.slowest();
      return new Longest(verdict.scenario(), Math.round(time * MILLISECOND), parts);
    }

    private static Longest of(ScenarioVerdict verdict, Measurements.Statistics chain) {
      return new Longest(verdict.scenario(), Math.round(chain.maximum() * MILLISECOND), List.of());
    }
  }

  private final SimulationResult result;
  private final List<Bounded> all = new ArrayList<>();

  private LatencyBounds(SimulationResult result) {
    this.result = result;
  }

  /** Returns the bounds of a chain with both ends known, and what was measured of them. */
  static LatencyBounds of(RunContext run, SimulationResult result) {
    LatencyBounds bounds = new LatencyBounds(result);
    EventChain chain = run.chain().chain();
    ChainTiming components = ChainTiming.of(chain, Stimuli.FRESH);
    ChainTiming timing = ChainTiming.of(chain, new BenchStimuli(run.chain().bench()));
    bounds.addChain(chain, timing);
    for (int i = 0; i < chain.getLatencyConstraints().size(); i++) {
      LatencyConstraint constraint = chain.getLatencyConstraints().get(i);
      if (constraint.getFirst() != null && constraint.getLast() != null) {
        int index = i;
        bounds.all.add(
            new Bounded(
                Optional.of(constraint),
                constraint.getFirst().getName(),
                constraint.getLast().getName(),
                components.of(constraint),
                timing.of(constraint),
                longest(
                    result,
                    verdict -> verdict.latencies().get(index).map(it -> Longest.of(verdict, it)))));
      }
    }
    return bounds;
  }

  /** Adds the latency of the whole chain, if one was measured. */
  private void addChain(EventChain chain, ChainTiming timing) {
    Optional<SoftwareNode> first = node(chain, result.measurements().firstNode());
    Optional<SoftwareNode> last = node(chain, result.measurements().lastNode());
    Optional<Longest> longest =
        longest(result, verdict -> verdict.latency().map(it -> Longest.of(verdict, it)));
    if (first.isPresent() && last.isPresent() && longest.isPresent()) {
      LatencyEstimate estimate = timing.reaction(first.get(), last.get());
      all.add(
          new Bounded(
              Optional.empty(),
              first.get().getName(),
              last.get().getName(),
              estimate,
              estimate,
              longest));
    }
  }

  private static Optional<SoftwareNode> node(EventChain chain, String name) {
    return chain.getSoftware().stream().filter(node -> name.equals(node.getName())).findFirst();
  }

  private static Optional<Longest> longest(
      SimulationResult result, Function<ScenarioVerdict, Optional<Longest>> ofScenario) {
    return result.verdicts().stream()
        .flatMap(verdict -> ofScenario.apply(verdict).stream())
        .max(Comparator.comparingLong(Longest::time));
  }

  /**
   * Returns all for the report, first that of the chain, then the constraints in their order, and
   * adds the findings about them. Where a run drives scenarios with standard faults, it also drives
   * them with the latency of the chain at its bound.
   */
  List<BoundedLatency> report(RunContext run, List<Scenario> scenarios, List<Diagnostic> found) {
    found.addAll(findings(run.chain()::locate));
    List<BoundedLatency> report = new ArrayList<>();
    for (Bounded each : all) {
      List<DelayedScenario> delayed = List.of();
      if (each.constraint().isEmpty() && RequirementStrength.budget(run).isPresent()) {
        delayed = LatencyMargins.of(run, scenarios, result, each.estimate().known());
        found.addAll(LatencyMargins.findings(delayed, scenarios, result));
      }
      report.add(BoundReport.of(each, delayed));
    }
    return report;
  }

  /**
   * Returns findings about measured times above their bounds, and about what only the bench adds to
   * those of the model.
   */
  private List<Diagnostic> findings(Function<EObject, SourceLocation> locator) {
    return all.stream()
        .flatMap(
            each -> {
              SourceLocation place = each.constraint().map(locator).orElse(SourceLocation.NONE);
              return Stream.of(
                      aboveBound(each, place), aboveMaximum(each, place), unknown(each, place))
                  .flatMap(Optional::stream);
            })
        .toList();
  }

  private static Optional<Diagnostic> aboveBound(Bounded bounded, SourceLocation place) {
    long bound = bounded.estimate().bound().orElse(Long.MAX_VALUE - TOLERANCE);
    return bounded
        .longest()
        .filter(longest -> longest.time() > bound + TOLERANCE)
        .map(
            longest ->
                Diagnostic.of(
                        SimulateRules.SIMULATION_LATENCY_ABOVE_BOUND,
                        "%s took %s ms in '%s', but by the numbers of the model %s ms are the most (waiting + execution: %s)."
                            .formatted(
                                bounded.name(),
                                LatencyEstimate.milliseconds(longest.time()),
                                longest.scenario(),
                                LatencyEstimate.milliseconds(bound),
                                bounded.estimate().shares()),
                        place)
                    .withHint(
                        "A worst case or a frequency of the model does not hold here, as where a component lacks an input and publishes nothing; if they all hold, this program has a defect."));
  }

  private static Optional<Diagnostic> aboveMaximum(Bounded bounded, SourceLocation place) {
    if (bounded.passes(bounded.components()) || !bounded.passes(bounded.estimate())) {
      return Optional.empty();
    }
    LatencyEstimate estimate = bounded.estimate();
    LatencyConstraint constraint = bounded.constraint().orElseThrow();
    long possible = estimate.bound().orElse(estimate.known());
    String message =
        "'%s' allows %s ms, but with what passes before '%s' starts up to %s ms are possible (waiting + execution: %s)."
            .formatted(
                constraint.getName(),
                LatencyEstimate.milliseconds(Math.round(constraint.getMaximum() * MILLISECOND)),
                constraint.getFirst().getName(),
                LatencyEstimate.milliseconds(possible),
                estimate.shares());
    return Optional.of(
        new Diagnostic(
            ContractRule.LATENCY_BOUND.rule(),
            Severity.WARNING,
            message,
            place,
            "Execute components on the way more often or faster, provide the messages more often, or allow more time.",
            "",
            List.of()));
  }

  private static Optional<Diagnostic> unknown(Bounded bounded, SourceLocation place) {
    boolean added =
        bounded.constraint().isPresent()
            && bounded.components().unknown().isEmpty()
            && !bounded.estimate().unknown().isEmpty();
    return added
        ? Optional.of(
            Diagnostic.of(
                    ContractRule.LATENCY_UNKNOWN.rule(),
                    "No bound on the time of %s is known: %s."
                        .formatted(bounded.name(), String.join("; ", bounded.estimate().unknown())),
                    place)
                .withHint(
                    "State a maximumAge of the input, or let no message of the topic get lost in bench.yaml."))
        : Optional.empty();
  }
}
