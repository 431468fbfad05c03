package dev.eventchain.simulation.judge;

import dev.eventchain.diagnostics.CommonTrait;
import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about the judgement of scenarios. */
final class JudgeRules {

  static final Rule QOS_DEADLINE_MISSED = Rule.warning("qos.deadline.missed");
  static final Rule QOS_LIVELINESS_LOST = Rule.warning("qos.liveliness.lost");
  static final Rule SIMULATION_ATTACHED_STATE = Rule.warning("simulation.attached.state");
  static final Rule SIMULATION_ATTACHED_UNSEEN = Rule.info("simulation.attached.unseen");
  static final Rule SIMULATION_END_OPEN = Rule.error("simulation.end.open", CommonTrait.UNTESTED);
  static final Rule SIMULATION_MESSAGE_LOST = Rule.warning("simulation.message.lost");

  private JudgeRules() {}
}
