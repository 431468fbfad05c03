package dev.eventchain.simulation;

import dev.eventchain.diagnostics.SourceLocation;
import java.util.List;

/** One thing that must hold in a scenario: a {@link Criterion} or a formula. */
interface Expectation {

  /** What must hold, in words. */
  String text();

  /** Where the scenario asks for it. */
  SourceLocation location();

  /** The numbers that it compares signals with; none where it compares in other ways. */
  List<ScenarioVerdict.Limit> limits();

  /** What was found. */
  Criterion.Outcome judge(Trace trace);
}
