package dev.eventchain.simulation.export;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about exported scenarios. */
final class ExportRules {

  static final Rule CONDITION = Rule.error("export.condition");
  static final Rule MANEUVER = Rule.error("export.maneuver");
  static final Rule INPUT = Rule.warning("export.input");

  private ExportRules() {}
}
