package dev.eventchain.agents;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about the dialogue with a language model. */
public final class AgentRules {

  public static final Rule ANSWER_REJECTED = Rule.error("agents.answer.rejected");
  public static final Rule ANSWER_RETURNED = Rule.info("agents.answer.returned");

  static final Rule DIAGNOSIS = Rule.error("agents.diagnosis");

  private AgentRules() {}
}
