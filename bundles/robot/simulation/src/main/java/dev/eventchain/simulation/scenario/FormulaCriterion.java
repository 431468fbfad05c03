package dev.eventchain.simulation.scenario;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.simulation.formula.Formula;
import dev.eventchain.simulation.formula.Outcome;
import dev.eventchain.simulation.formula.SampledRun;
import dev.eventchain.simulation.formula.Signal;
import dev.eventchain.simulation.formula.WorldSignals;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import dev.eventchain.simulation.world.Trace;
import java.util.List;
import java.util.Set;

/**
 * A formula that must hold in a scenario.
 *
 * @param name its name for users; may be empty
 * @param form what it asks for, as far as its key says so
 * @param location its location in the scenario
 * @param requirements ids of the requirements that it tests
 */
public record FormulaCriterion(
    String name, Formula formula, Form form, SourceLocation location, List<String> requirements)
    implements Expectation {

  /** Demand of a criterion. */
  enum Form {
    /** Truth of its formula. */
    WRITTEN,
    /** That the software brings something about. */
    GOAL,
    /** That the software brings a signal to its target. */
    SETTLES
  }

  /** Copies the list. */
  public FormulaCriterion {
    requirements = List.copyOf(requirements);
  }

  @Override
  public FormulaCriterion testing(List<String> ids) {
    return new FormulaCriterion(name, formula, form, location, ids);
  }

  @Override
  public String text() {
    return name.isEmpty() ? formula.text() : name + " (" + formula.text() + ")";
  }

  @Override
  public String title() {
    return name.isEmpty() ? text() : name;
  }

  @Override
  public List<ScenarioVerdict.Limit> limits() {
    return formula.limits();
  }

  @Override
  public Set<Signal> signals() {
    return formula.signals();
  }

  @Override
  public boolean dependsOn(Set<String> topics, boolean commanding) {
    return formula.signals().stream()
        .flatMap(Signal::origins)
        .anyMatch(
            signal ->
                signal
                    .topic()
                    .map(topics::contains)
                    .orElse(commanding && WorldSignals.isKnown(signal.name())));
  }

  @Override
  public long horizon() {
    return formula.horizon();
  }

  /**
   * Returns whether it asks for something that the software has to bring about, and not only for a
   * limit that it must not exceed.
   */
  public boolean isGoal() {
    return form == Form.GOAL || !formula.isLimit();
  }

  /** Returns whether a signal was at the target that it is to settle at from the start of a run. */
  public boolean isSettled(Trace trace) {
    return form == Form.SETTLES && formula.heldBefore(new SampledRun(trace));
  }

  /** Returns whether it is certainly true. */
  public boolean holds(Trace trace) {
    return formula.holds(new SampledRun(trace));
  }

  @Override
  public Outcome judge(Trace trace) {
    return formula.judge(trace);
  }

  @Override
  public boolean cameToPremise(Trace trace) {
    return formula.cameToPremise(trace);
  }

  @Override
  public boolean isViolated(Trace beginning) {
    return formula.isViolated(SampledRun.beginning(beginning));
  }
}
