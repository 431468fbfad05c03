package dev.eventchain.simulation;

import dev.eventchain.diagnostics.SourceLocation;

/** One thing that must hold in a scenario: a {@link Criterion} or a formula. */
interface Expectation {

  /** What must hold, in words. */
  String text();

  /** Where the scenario asks for it. */
  SourceLocation location();

  /** What was found. */
  Criterion.Outcome judge(Trace trace);
}
