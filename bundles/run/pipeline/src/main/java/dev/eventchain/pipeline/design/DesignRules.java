package dev.eventchain.pipeline.design;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about designed and written components. */
final class DesignRules {

  static final Rule AGENTS_VERDICT_QUESTION = Rule.error("agents.verdict.question");
  static final Rule AGENTS_VERDICT_UNCORRECTED = Rule.warning("agents.verdict.uncorrected");
  static final Rule NOTHING_RETRIEVED = Rule.warning("catalogue.nothing-retrieved");
  static final Rule COMPONENT_TESTS_UNUSED = Rule.error("component.tests.unused");

  private DesignRules() {}
}
