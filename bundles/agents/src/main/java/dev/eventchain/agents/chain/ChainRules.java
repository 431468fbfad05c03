package dev.eventchain.agents.chain;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about designed chains. */
final class ChainRules {

  static final Rule FREQUENCY = Rule.error("agents.frequency");
  static final Rule ORDER = Rule.warning("agents.order");
  static final Rule REQUIREMENT_UNSATISFIED = Rule.error("agents.requirement.unsatisfied");
  static final Rule SAFE_VALUE = Rule.error("agents.safe-value");
  static final Rule TYPE = Rule.error("agents.type");

  private ChainRules() {}
}
