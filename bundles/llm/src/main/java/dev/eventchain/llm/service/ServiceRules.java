package dev.eventchain.llm.service;

import dev.eventchain.diagnostics.Rule;
import dev.eventchain.llm.chat.AnswerTrait;

/** Rules of the findings about services on the network. */
final class ServiceRules {

  static final Rule ANSWER_CUT = Rule.error("llm.answer.cut", AnswerTrait.UNANSWERED);
  static final Rule ANSWER_LATE = Rule.error("llm.answer.late", AnswerTrait.UNANSWERED);
  static final Rule ANSWER_UNREADABLE = Rule.error("llm.answer.unreadable", AnswerTrait.UNANSWERED);
  static final Rule KEY_MISSING =
      Rule.error("llm.key.missing", AnswerTrait.UNANSWERED, AnswerTrait.LASTING);
  static final Rule KEY_REFUSED =
      Rule.error("llm.key.refused", AnswerTrait.UNANSWERED, AnswerTrait.LASTING);
  static final Rule QUOTA_SPENT =
      Rule.error("llm.quota.spent", AnswerTrait.UNANSWERED, AnswerTrait.LASTING);
  static final Rule REQUEST_REJECTED = Rule.error("llm.request.rejected", AnswerTrait.UNANSWERED);
  static final Rule SERVICE_FAILED = Rule.error("llm.service.failed", AnswerTrait.UNANSWERED);
  static final Rule SERVICE_LIMITED = Rule.error("llm.service.limited", AnswerTrait.UNANSWERED);
  static final Rule SERVICE_UNREACHABLE =
      Rule.error("llm.service.unreachable", AnswerTrait.UNANSWERED, AnswerTrait.LASTING);
  static final Rule SERVICE_URL = Rule.error("llm.service.url", AnswerTrait.UNANSWERED);
  static final Rule SERVICE_WIRE = Rule.error("llm.service.wire", AnswerTrait.UNANSWERED);

  private ServiceRules() {}
}
