package dev.eventchain.maven;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about the parameters of goals. */
final class GoalRules {

  static final Rule NOTHING_TO_CHECK = Rule.error("maven.nothing-to-check");
  static final Rule PARAMETER = Rule.error("maven.parameter");

  private GoalRules() {}
}
