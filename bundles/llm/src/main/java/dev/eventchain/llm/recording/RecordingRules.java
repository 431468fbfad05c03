package dev.eventchain.llm.recording;

import dev.eventchain.diagnostics.Rule;
import dev.eventchain.llm.chat.AnswerTrait;

/** Rules of the findings about recordings. */
final class RecordingRules {

  static final Rule RECORDING_FORMAT = Rule.error("llm.recording.format", AnswerTrait.UNANSWERED);
  static final Rule RECORDING_JSON = Rule.error("llm.recording.json", AnswerTrait.UNANSWERED);
  static final Rule RECORDING_KEY = Rule.error("llm.recording.key", AnswerTrait.UNANSWERED);
  static final Rule RECORDING_UNWRITABLE =
      Rule.error("llm.recording.unwritable", AnswerTrait.UNANSWERED);

  private RecordingRules() {}
}
