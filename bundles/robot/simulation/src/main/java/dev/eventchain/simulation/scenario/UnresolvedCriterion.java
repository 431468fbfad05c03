package dev.eventchain.simulation.scenario;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.simulation.formula.Outcome;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import dev.eventchain.simulation.world.Trace;
import java.util.List;
import java.util.Set;

/**
 * A formula on an output that the chain does not have, or of which it has several: it is never
 * tested.
 *
 * @param text the criterion, for users
 * @param reason why there is no single output
 * @param location its location in the scenario
 * @param requirements ids of the requirements that it tests
 */
record UnresolvedCriterion(
    String text, String reason, SourceLocation location, List<String> requirements)
    implements Expectation {

  /** Copies the list. */
  UnresolvedCriterion {
    requirements = List.copyOf(requirements);
  }

  /** Returns the finding that nothing can be judged, for people before they simulate. */
  Diagnostic finding() {
    return Diagnostic.of(
            ScenarioRules.OUTPUT_UNRESOLVED,
            "'" + text + "' cannot be tested: " + reason + ".",
            location)
        .withHint(
            "Let exactly one output of the design name the requirement, or add its type or unit:"
                + " output(ID, bool), output(ID, m/s2). output(ID) > 0.5 reads a Boolean or a number.");
  }

  @Override
  public boolean isUnresolved() {
    return true;
  }

  @Override
  public UnresolvedCriterion testing(List<String> ids) {
    return new UnresolvedCriterion(text, reason, location, ids);
  }

  @Override
  public List<ScenarioVerdict.Limit> limits() {
    return List.of();
  }

  @Override
  public boolean dependsOn(Set<String> topics, boolean commanding) {
    return true; // As far as is known: a component that lacks the output may get it.
  }

  @Override
  public Outcome judge(Trace trace) {
    return Outcome.untested(reason);
  }

  @Override
  public boolean isViolated(Trace beginning) {
    return false;
  }
}
