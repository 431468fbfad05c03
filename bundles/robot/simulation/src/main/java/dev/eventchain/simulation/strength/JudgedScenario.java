package dev.eventchain.simulation.strength;

import dev.eventchain.simulation.fault.OutputFault;
import dev.eventchain.simulation.judge.ScenarioJudge;
import dev.eventchain.simulation.run.OutputRecord;
import dev.eventchain.simulation.run.ScenarioRun;
import dev.eventchain.simulation.scenario.Expectation;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.ScenarioVerdict.CriterionResult;
import dev.eventchain.simulation.world.Trace;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * A scenario without faults, and which of its own criteria hold there. Those of every scenario say
 * nothing about a requirement.
 */
final class JudgedScenario {

  private final Scenario scenario;
  private final ScenarioJudge judge;
  private final OutputRecord published;
  private final List<CriterionResult> results;

  JudgedScenario(ScenarioRun run, ScenarioJudge judge) {
    List<Expectation> own =
        run.scenario().criteria().stream().filter(each -> !each.isOfEveryScenario()).toList();
    this.scenario = run.scenario().with(own);
    this.judge = judge;
    this.published = run.outputs();
    this.results = judge.criteria(run.with(scenario), true);
  }

  /** Returns the scenario with its own criteria only. */
  Scenario scenario() {
    return scenario;
  }

  /** Returns the number of its own criteria. */
  int criteria() {
    return results.size();
  }

  /** Returns whether it names a requirement. */
  boolean names(String requirement) {
    return scenario.requirements().contains(requirement);
  }

  /** Returns whether a criterion belongs to a requirement and holds without faults. */
  boolean proves(int criterion, String requirement) {
    CriterionResult result = results.get(criterion);
    return result.passed() && result.requirements().contains(requirement);
  }

  /** Returns the criteria that belong to a requirement and hold without faults. */
  Set<Integer> proving(String requirement) {
    return IntStream.range(0, results.size())
        .filter(criterion -> proves(criterion, requirement))
        .boxed()
        .collect(Collectors.toSet());
  }

  /** Returns the result of a criterion without faults. */
  CriterionResult result(int criterion) {
    return results.get(criterion);
  }

  /** Judges its own criteria in a run of it with a fault. */
  List<CriterionResult> results(ScenarioRun run) {
    return judge.criteriaWithoutEvidence(run.with(scenario));
  }

  /** Returns the criteria that hold without faults and fail in every run that begins like this. */
  Set<Integer> violated(Trace beginning) {
    Set<Integer> violated = new TreeSet<>();
    for (int i = 0; i < results.size(); i++) {
      if (results.get(i).passed() && scenario.criteria().get(i).isViolated(beginning)) {
        violated.add(i);
      }
    }
    return violated;
  }

  /**
   * Returns false if a fault certainly changes no message: the output has in this scenario what the
   * fault makes of it anyway.
   */
  boolean canChange(OutputFault fault, List<String> fields) {
    if (fault.field().isEmpty()) {
      return fields.stream().anyMatch(field -> canChange(fault, field));
    }
    return canChange(fault, fault.field());
  }

  private boolean canChange(OutputFault fault, String field) {
    if (!published.has(fault.topic(), field)) {
      return false;
    }
    OutputRecord.Values values = published.of(fault.topic(), field);
    return switch (fault.change()) {
      case DROPPED, NEGATED -> true;
      case FIRST, HELD, DELAYED -> values.changed();
      case STUCK -> !values.isAlways(fault.amount());
      case SCALED, INVERTED -> !values.isAlways(0);
      case SHIFTED, NOISY -> values.hasNumbers();
    };
  }
}
