package dev.eventchain.llm.handoff;

import dev.eventchain.diagnostics.Rule;
import dev.eventchain.llm.chat.AnswerTrait;

/** Rules of the findings about answers of people and programs. */
final class HandoffRules {

  static final Rule COMMAND_FAILED = Rule.error("llm.command.failed", AnswerTrait.UNANSWERED);
  static final Rule HANDOFF_UNWRITABLE =
      Rule.error("llm.handoff.unwritable", AnswerTrait.UNANSWERED);

  private HandoffRules() {}
}
