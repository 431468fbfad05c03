package dev.eventchain.simulation.stage;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about scenarios in OpenSCENARIO XML on the stage of the world. */
final class StageRules {

  static final Rule EGO_MOVED = Rule.error("scenario.ego.moved");
  static final Rule EGO = Rule.error("scenario.ego.unknown");

  private StageRules() {}
}
