package dev.eventchain.llm.chat;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about answers that are not there yet. */
public final class AnswerRules {

  public static final Rule HANDOFF_WAITING =
      Rule.error("llm.handoff.waiting", AnswerTrait.UNANSWERED);
  public static final Rule RECORDING_EXHAUSTED =
      Rule.error("llm.recording.exhausted", AnswerTrait.UNANSWERED, AnswerTrait.UNRECORDED);
  public static final Rule RECORDING_MISSING =
      Rule.error("llm.recording.missing", AnswerTrait.UNANSWERED, AnswerTrait.UNRECORDED);

  private AnswerRules() {}
}
