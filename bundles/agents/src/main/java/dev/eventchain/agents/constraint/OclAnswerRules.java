package dev.eventchain.agents.constraint;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about written constraints. */
final class OclAnswerRules {

  static final Rule CONSTRAINT_NONE = Rule.error("agents.constraint.none");
  static final Rule CONSTRAINT_VACUOUS = Rule.error("agents.constraint.vacuous");
  static final Rule RULE_UNCOVERED = Rule.error("agents.rule.uncovered");

  private OclAnswerRules() {}
}
