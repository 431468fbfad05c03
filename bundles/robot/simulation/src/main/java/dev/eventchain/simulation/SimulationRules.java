package dev.eventchain.simulation;

import dev.eventchain.diagnostics.CommonTrait;
import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about simulations. */
final class SimulationRules {

  static final Rule FAULT_DRIVER = Rule.error("fault.driver");
  static final Rule SIMULATION_COMMAND_IGNORED =
      Rule.error("simulation.command.ignored", CommonTrait.UNTESTED);
  static final Rule SIMULATION_IMPACT_UNJUDGED =
      Rule.error("simulation.impact.unjudged", CommonTrait.UNTESTED);
  static final Rule SIMULATION_NOT_REPEATABLE =
      Rule.error("simulation.not-repeatable", CommonTrait.UNTESTED);
  static final Rule SIMULATION_EGO_HIT_FROM_BEHIND = Rule.warning("simulation.ego.hit-from-behind");

  private SimulationRules() {}
}
