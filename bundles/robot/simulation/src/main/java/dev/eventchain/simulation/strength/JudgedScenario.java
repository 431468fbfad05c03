package dev.eventchain.simulation.strength;

import dev.eventchain.simulation.fault.OutputFault;
import dev.eventchain.simulation.judge.ScenarioJudge;
import dev.eventchain.simulation.run.OutputRecord;
import dev.eventchain.simulation.run.ScenarioRun;
import dev.eventchain.simulation.scenario.Expectation;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.ScenarioVerdict.CriterionResult;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.World;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;

/**
 * A scenario without faults, and which of its own criteria hold there. Those of every scenario say
 * nothing about a requirement.
 */
final class JudgedScenario {

  /** A time for scenarios that take none, in s. */
  private static final double SHORTEST = 0.1;

  private final Scenario scenario;
  private final ScenarioJudge judge;
  private final OutputRecord published;
  private final List<CriterionResult> results;
  private final Map<String, Set<Integer>> proving = new TreeMap<>();
  private final double seconds;

  JudgedScenario(ScenarioRun run, ScenarioJudge judge) {
    List<Expectation> own =
        run.scenario().criteria().stream().filter(each -> !each.isOfEveryScenario()).toList();
    this.scenario = run.scenario().with(own);
    this.judge = judge;
    this.published = run.outputs();
    this.results = judge.criteria(run.with(scenario), true);
    this.seconds = Math.max(World.seconds(run.trace().end().time()), SHORTEST);
    for (String id : scenario.requirements()) {
      Set<Integer> criteria = new TreeSet<>();
      for (int i = 0; i < results.size(); i++) {
        if (proves(i, id)) {
          criteria.add(i);
        }
      }
      proving.put(id, criteria);
    }
  }

  /** Returns the scenario with its own criteria only. */
  Scenario scenario() {
    return scenario;
  }

  /** Returns the number of its own criteria. */
  int criteria() {
    return results.size();
  }

  /** Returns the simulated time that it takes without faults, in s. */
  double seconds() {
    return seconds;
  }

  /** Returns the requirements that a criterion belongs to which holds without faults. */
  Set<String> proved() {
    return proving.keySet().stream().filter(this::proves).collect(Collectors.toSet());
  }

  /** Returns whether a criterion belongs to a requirement and holds without faults. */
  boolean proves(String requirement) {
    return !proving(requirement).isEmpty();
  }

  /** Returns whether a criterion belongs to a requirement and holds without faults. */
  boolean proves(int criterion, String requirement) {
    CriterionResult result = results.get(criterion);
    return result.passed() && result.requirements().contains(requirement);
  }

  /** Returns the criteria that belong to a requirement and hold without faults. */
  Set<Integer> proving(String requirement) {
    return proving.getOrDefault(requirement, Set.of());
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
