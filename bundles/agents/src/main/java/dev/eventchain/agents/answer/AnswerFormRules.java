package dev.eventchain.agents.answer;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about the form of answers. */
final class AnswerFormRules {

  static final Rule ANSWER_JSON = Rule.error("agents.answer.json");
  static final Rule ANSWER_NONE = Rule.error("agents.answer.none");
  static final Rule ANSWER_REFUSED = Rule.error("agents.answer.refused");
  static final Rule ANSWER_SEVERAL = Rule.error("agents.answer.several");
  static final Rule ANSWER_TRUNCATED = Rule.error("agents.answer.truncated");

  private AnswerFormRules() {}
}
