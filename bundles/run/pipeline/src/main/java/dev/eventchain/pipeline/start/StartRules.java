package dev.eventchain.pipeline.start;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about new projects. */
final class StartRules {

  static final Rule EXISTS = Rule.error("project.exists");
  static final Rule FOREIGN = Rule.error("project.foreign");

  private StartRules() {}
}
