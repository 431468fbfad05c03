package dev.eventchain.pipeline.stage;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about the order of stages. */
public final class StageRules {

  public static final Rule STAGE_MISSING = Rule.error("project.stage.missing");

  private StageRules() {}
}
