package dev.eventchain.pipeline.evaluation;

import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about evaluations of language models. */
final class EvaluationRules {

  static final Rule ANSWERS_ENDED = Rule.warning("evaluation.answers.ended");
  static final Rule ANSWER_UNUSED = Rule.warning("evaluation.answer.unused");
  static final Rule AUTHORED = Rule.warning("evaluation.authored");
  static final Rule NOTHING_COUNTED = Rule.error("evaluation.nothing.counted");
  static final Rule REFERENCE_MISSING = Rule.warning("evaluation.reference.missing");
  static final Rule RUN_UNCOUNTED = Rule.warning("evaluation.run.uncounted");

  private EvaluationRules() {}
}
