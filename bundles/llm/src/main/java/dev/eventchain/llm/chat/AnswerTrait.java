package dev.eventchain.llm.chat;

import dev.eventchain.diagnostics.Rule;

/** Properties of rules about calls of language models, for those who ask more than once. */
public enum AnswerTrait implements Rule.Trait {
  /** The model gave no answer, or the call was not made. */
  UNANSWERED,

  /** The answer is in no recording. */
  UNRECORDED,

  /** The same model gives no answer to the next call either. */
  LASTING,

  /** No model is called any more, since the budget is spent or unknown. */
  ENDING
}
