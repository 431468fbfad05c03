package dev.eventchain.pipeline.design;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.pipeline.stage.FailedVerdict;
import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.simulation.SimulationResult;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import dev.eventchain.simulation.verdict.ScenarioVerdict.CriterionResult;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.Collectors;

/**
 * The scenarios of a simulation that failed by a criterion, or in which a criterion could not be
 * tested as the chain has no such output.
 */
final class FailedScenarios {
  private final RunContext run;
  private final Bench bench;
  private final List<ScenarioVerdict> verdicts;
  private final Map<String, Scenario> scenarios;
  private final TopicIndex topics;

  private FailedScenarios(RunContext run, SimulationResult simulated) {
    this.run = run;
    this.bench = run.chain().bench();
    this.topics = TopicIndex.of(run.chain().chain());
    this.scenarios =
        Scenario.readFolder(run.project().scenarios(), bench, warning -> {}).stream()
            .collect(Collectors.toMap(Scenario::name, Function.identity()));
    this.verdicts =
        simulated.verdicts().stream()
            .filter(verdict -> verdict.worked() && !missed(verdict).isEmpty())
            .toList();
  }

  /** Returns what language models are told about the scenarios of a simulation that failed. */
  static FailedVerdict of(RunContext run, SimulationResult simulated) {
    FailedScenarios failed = new FailedScenarios(run, simulated);
    List<SoftwareNode> path = failed.path();
    Map<String, String> texts = new TreeMap<>();
    path.forEach(node -> texts.put(node.getName(), VerdictText.of(List.of(node), failed)));
    return new FailedVerdict(
        !failed.verdicts.isEmpty(),
        path.stream().map(SoftwareNode::getName).toList(),
        VerdictText.of(path, failed),
        texts);
  }

  /** Returns the verdicts on these scenarios. */
  List<ScenarioVerdict> verdicts() {
    return verdicts;
  }

  /** Returns the criteria of a scenario that failed, or read an output that the chain lacks. */
  List<CriterionResult> missed(ScenarioVerdict verdict) {
    Set<SourceLocation> unresolved =
        Optional.ofNullable(scenarios.get(verdict.scenario())).stream()
            .flatMap(scenario -> scenario.unresolved().stream())
            .map(Diagnostic::location)
            .collect(Collectors.toSet());
    return verdict.criteria().stream()
        .filter(each -> !each.passed())
        .filter(each -> each.tested() || unresolved.contains(each.location()))
        .toList();
  }

  /** Returns the components whose outputs can reach a signal of what failed, in chain order. */
  private List<SoftwareNode> path() {
    return run.chain().chain().getSoftware().stream().filter(this::mayBeTheCause).toList();
  }

  private boolean mayBeTheCause(SoftwareNode node) {
    Set<String> influenced = topics.influencedBy(List.of(node));
    return verdicts.stream()
        .anyMatch(
            verdict -> missed(verdict).stream().anyMatch(each -> reads(verdict, each, influenced)));
  }

  private boolean reads(ScenarioVerdict verdict, CriterionResult missed, Set<String> influenced) {
    return Optional.ofNullable(scenarios.get(verdict.scenario()))
        .map(scenario -> scenario.dependsOn(missed.location(), influenced, bench))
        .orElse(true);
  }
}
