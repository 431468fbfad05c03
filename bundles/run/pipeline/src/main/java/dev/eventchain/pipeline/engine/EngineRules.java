package dev.eventchain.pipeline.engine;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about earlier stages. */
final class EngineRules {

  static final Rule STAGE_OUTDATED = Rule.error("project.stage.outdated");

  static final Rule VERDICT_FAILED = Rule.error("project.verdict.failed");

  private EngineRules() {}
}
