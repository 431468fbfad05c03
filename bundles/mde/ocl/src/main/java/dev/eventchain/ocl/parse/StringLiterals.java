package dev.eventchain.ocl.parse;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.ocl.text.ExpressionRules;
import dev.eventchain.ocl.text.Lexer;
import java.util.List;

/** Warns of misleading string literals. */
public final class StringLiterals {

  private StringLiterals() {}

  /** Finds two literals without a space between: {@code 'it''s'} is {@code its}. */
  public static void check(SourceRange range, List<Diagnostic> problems) {
    String text = range.source().text();
    int end = range.end();
    int i = range.start();
    while (i < end) {
      int next = Lexer.end(text, i, end);
      boolean literal = text.charAt(i) == '\'' && next - i > 1;
      if (literal && next < end && text.charAt(next) == '\'') {
        problems.add(
            Diagnostic.of(
                    ExpressionRules.STRING_QUOTE,
                    "Two quotes do not make a quote: the two strings are joined.",
                    range.source().at(next - 1))
                .withHint("Write \\' for a quote inside a string."));
      }
      i = next;
    }
  }
}
