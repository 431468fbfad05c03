package dev.eventchain.simulation.verdict;

import dev.eventchain.diagnostics.CommonTrait;
import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about verdicts. */
final class VerdictRules {

  static final Rule CRITERION_FAILED =
      Rule.error("simulation.criterion.failed", CommonTrait.UNSUPPRESSIBLE);
  static final Rule CRITERION_UNTESTED =
      Rule.error("simulation.criterion.untested", CommonTrait.UNTESTED);
  static final Rule FAULT_FAILED = Rule.error("simulation.fault.failed");
  static final Rule FAULT_NO_EFFECT =
      Rule.error("simulation.fault.no-effect", CommonTrait.UNTESTED);
  static final Rule FAULT_UNTESTED = Rule.error("simulation.fault.untested", CommonTrait.UNTESTED);

  private VerdictRules() {}
}
