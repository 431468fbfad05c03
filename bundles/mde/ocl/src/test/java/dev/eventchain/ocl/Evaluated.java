package dev.eventchain.ocl;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.ocl.evaluation.Evaluation;
import java.util.ArrayList;
import java.util.List;

/** Evaluates texts. */
final class Evaluated {

  private Evaluated() {}

  /** Returns the value of a text, which must be an expression. */
  static Object value(ExpressionLanguage language, SourceText text, Scope scope, Evaluation run) {
    List<Diagnostic> problems = new ArrayList<>();
    return language
        .parse(text.whole(), scope, problems)
        .orElseThrow(() -> new AssertionError(problems))
        .evaluate(run);
  }
}
