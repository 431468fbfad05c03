package dev.eventchain.llm;

import dev.eventchain.diagnostics.Rule;
import dev.eventchain.llm.chat.AnswerTrait;

/** Rules of the findings about the choice of language models and their budget. */
final class LlmRules {

  static final Rule BUDGET_SPENT =
      Rule.error("llm.budget.spent", AnswerTrait.UNANSWERED, AnswerTrait.ENDING);
  static final Rule HANDOFF_FOLDER = Rule.error("llm.handoff.folder", AnswerTrait.UNANSWERED);
  static final Rule MODEL_DIFFERS = Rule.warning("llm.model.differs");
  static final Rule MODEL_FALLBACK = Rule.warning("llm.model.fallback");
  static final Rule MODEL_NAME = Rule.error("llm.model.name", AnswerTrait.UNANSWERED);
  static final Rule PRICE_MISSING =
      Rule.error("llm.price.missing", AnswerTrait.UNANSWERED, AnswerTrait.ENDING);
  static final Rule PROVIDER_UNKNOWN = Rule.error("llm.provider.unknown", AnswerTrait.UNANSWERED);
  static final Rule SERVICE_UNKNOWN = Rule.error("llm.service.unknown", AnswerTrait.UNANSWERED);

  private LlmRules() {}
}
