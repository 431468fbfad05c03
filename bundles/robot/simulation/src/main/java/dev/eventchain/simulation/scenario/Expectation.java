package dev.eventchain.simulation.scenario;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.simulation.formula.Outcome;
import dev.eventchain.simulation.formula.Signal;
import dev.eventchain.simulation.verdict.ScenarioVerdict;
import dev.eventchain.simulation.world.Trace;
import java.util.List;
import java.util.Set;

/** One thing that must hold in a scenario: a {@link Criterion} or a formula. */
public interface Expectation {

  /** What must hold, in words. */
  String text();

  /** Where the scenario asks for it. */
  SourceLocation location();

  /** The numbers that it compares signals with; none where it compares in other ways. */
  List<ScenarioVerdict.Limit> limits();

  /** The signals that it reads besides the world's own record. */
  default Set<Signal> signals() {
    return Set.of();
  }

  /**
   * Whether it depends on what is written on some topics.
   *
   * @param commanding whether one of them commands the vehicle
   */
  boolean dependsOn(Set<String> topics, boolean commanding);

  /**
   * Until when a run is needed to judge it, in ns; 0 if what happens until standstill is enough.
   */
  default long horizon() {
    return 0;
  }

  /** What was found. */
  Outcome judge(Trace trace);
}
