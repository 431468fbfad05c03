package dev.eventchain.pipeline.stage;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about what all stages share. */
public final class StageRules {

  public static final Rule STAGE_MISSING = Rule.error("project.stage.missing");

  static final Rule COMPONENT_SOURCE_UNCHECKED = Rule.warning("component.source.unchecked");

  static final Rule SCENARIO_JUDGES_MISSING = Rule.warning("scenario.judges.missing");
  static final Rule SCENARIO_JUDGES_NUMBER = Rule.warning("scenario.judges.number");
  static final Rule SCENARIO_JUDGES_WORDS = Rule.error("scenario.judges.words");

  private StageRules() {}
}
