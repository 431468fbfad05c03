package dev.eventchain.agents.component;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about tests of components. */
final class TestRules {

  static final Rule TEST_FAILED = Rule.error("component.test.failed");
  static final Rule TESTS_CONTRADICTION = Rule.error("component.tests.contradiction");
  static final Rule TESTS_FORMAT = Rule.error("component.tests.format");
  static final Rule TESTS_GAP = Rule.error("component.tests.gap");
  static final Rule TESTS_REQUIREMENT = Rule.error("component.tests.requirement");

  private TestRules() {}
}
