package dev.eventchain.simulation.judge;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.simulation.formula.Outcome;
import dev.eventchain.simulation.scenario.Expectation;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.ScenarioVerdict.CriterionResult;
import dev.eventchain.simulation.verdict.ScenarioVerdict.Judged;
import dev.eventchain.simulation.verdict.ScenarioVerdict.Limit;
import java.util.List;
import java.util.Optional;

/**
 * A criterion, as its result describes it.
 *
 * @param judges the words of requirements that it judges
 * @param limits the numbers that signals are compared with
 * @param requirements ids of the requirements that it tests
 */
record JudgedCriterion(
    String text,
    List<Judged> judges,
    List<Limit> limits,
    SourceLocation location,
    List<String> requirements) {

  static JudgedCriterion of(Scenario scenario, Expectation criterion) {
    return new JudgedCriterion(
        criterion.text(),
        scenario.judgedBy(criterion),
        criterion.limits(),
        criterion.location(),
        criterion.requirements());
  }

  /** Returns a criterion that reads no signal and names no requirement. */
  static JudgedCriterion withoutSignals(String text, SourceLocation location) {
    return new JudgedCriterion(text, List.of(), List.of(), location, List.of());
  }

  CriterionResult result(Outcome outcome) {
    return new CriterionResult(
        text,
        outcome.tested(),
        outcome.passed(),
        outcome.detail(),
        outcome.margin(),
        outcome.decided(),
        outcome.otherwise(),
        judges,
        limits,
        location,
        requirements,
        Optional.empty());
  }
}
