package dev.eventchain.simulation.judge;

import dev.eventchain.simulation.formula.Outcome;
import dev.eventchain.simulation.run.ScenarioRun;
import dev.eventchain.simulation.scenario.Expectation;
import java.util.Optional;

/** Conditions that make a run the test which its scenario describes, such as the speed of it. */
final class TestConditions {

  private TestConditions() {}

  /**
   * Returns why nothing can be said of a run; empty if all conditions hold, as far as it went. One
   * that a run ended before holds so far, and one with a premise that never came true holds.
   */
  static Optional<Outcome> broken(ScenarioRun run) {
    return run.scenario().conditions().stream()
        .flatMap(each -> broken(each, run).stream())
        .findFirst();
  }

  private static Optional<Outcome> broken(Expectation condition, ScenarioRun run) {
    Outcome outcome = condition.judge(run.trace());
    String words = condition.title() + ": " + outcome.detail();
    if (outcome.failed()) {
      return Optional.of(Outcome.untested("this was not the test, " + words));
    }
    return outcome.missing().isEmpty() && !condition.isUnresolved()
        ? Optional.empty()
        : Optional.of(Outcome.untested("nobody knows if this was the test, " + words));
  }
}
