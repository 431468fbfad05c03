package dev.eventchain.pipeline.simulate;

import dev.eventchain.diagnostics.CommonTrait;
import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about what a simulation of a project leaves open. */
public final class SimulateRules {

  static final Rule PROJECT_REQUIREMENT_STALE =
      Rule.error("project.requirement.stale", CommonTrait.UNTESTED);
  static final Rule PROJECT_REQUIREMENT_UNTESTED =
      Rule.error("project.requirement.untested", CommonTrait.UNTESTED);
  static final Rule PROJECT_SCENARIO_UNKNOWN = Rule.error("project.scenario.unknown");
  static final Rule SIMULATION_INTERRUPTED = Rule.error("simulation.interrupted");
  static final Rule SIMULATION_LATENCY_ABOVE_BOUND = Rule.warning("simulation.latency.above-bound");
  static final Rule SIMULATION_LATENCY_AT_BOUND = Rule.warning("simulation.latency.at-bound");
  static final Rule SIMULATION_LATENCY_LOWER_BOUND =
      Rule.error("simulation.latency.lower-bound", CommonTrait.UNTESTED);
  static final Rule SIMULATION_LATENCY_UNMEASURED =
      Rule.error("simulation.latency.unmeasured", CommonTrait.UNTESTED);

  /** That of a constraint which implements requirements; its message names them. */
  public static final Rule SIMULATION_RULE_UNTESTED =
      Rule.error("simulation.rule.untested", CommonTrait.UNTESTED);

  static final Rule SIMULATION_SIGNAL_UNSHOWN = Rule.info("simulation.signal.unshown");

  static final Rule SIMULATION_STRENGTH_IDLE =
      Rule.error("simulation.strength.idle", CommonTrait.UNTESTED);
  static final Rule SIMULATION_STRENGTH_LOW =
      Rule.error("simulation.strength.low", CommonTrait.UNTESTED);
  static final Rule SIMULATION_STRENGTH_NONE =
      Rule.error("simulation.strength.none", CommonTrait.UNTESTED);

  static final Rule SIMULATION_TIME_MEASURED = Rule.info("simulation.time.measured");

  private SimulateRules() {}
}
