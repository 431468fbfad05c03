package dev.eventchain.simulation.scenario;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.simulation.formula.Outcome;
import dev.eventchain.simulation.formula.Signal;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import dev.eventchain.simulation.world.Trace;
import java.util.List;
import java.util.Set;

/** A requirement on a scenario: a {@link Criterion} or a formula. */
public interface Expectation {

  /** Returns the requirement in words. */
  String text();

  /** Returns its name, or else the requirement in words. */
  default String title() {
    return text();
  }

  /** Returns its location in the scenario. */
  SourceLocation location();

  /** Returns the ids of the requirements that it tests. */
  List<String> requirements();

  /** Returns a copy that tests other requirements. */
  Expectation testing(List<String> requirements);

  /** Returns whether it is asked in every scenario, so that it proves no requirement by itself. */
  default boolean isOfEveryScenario() {
    return false;
  }

  /** Returns whether it is on an output of which the chain has none or several. */
  default boolean isUnresolved() {
    return false;
  }

  /** Returns the numbers that it compares signals with; empty for other comparisons. */
  List<ScenarioVerdict.Limit> limits();

  /** Returns the signals that it reads besides the world's own record. */
  default Set<Signal> signals() {
    return Set.of();
  }

  /**
   * Returns whether it depends on the messages on some topics.
   *
   * @param commanding true if one of them commands the vehicle
   */
  boolean dependsOn(Set<String> topics, boolean commanding);

  /**
   * Returns the end of the part of a run that the verdict needs, in ns; 0 if the run until
   * standstill is enough.
   */
  default long horizon() {
    return 0;
  }

  /** Judges a trace. */
  Outcome judge(Trace trace);

  /**
   * Returns whether a run that ended too early to decide it came to what it asks for: a premise
   * came true, or it has none; false where only its kind tells when it asks for something.
   */
  default boolean cameToPremise(Trace trace) {
    return false;
  }

  /**
   * Returns whether it fails in every run that begins like this.
   *
   * @param beginning the trace of a run that goes on
   */
  boolean isViolated(Trace beginning);
}
