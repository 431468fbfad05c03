package dev.eventchain.ocl.parse;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.ocl.text.ExpressionRules;
import java.util.List;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.eclipse.ocl.lpg.AbstractProblemHandler;

/** Converts the problems of Eclipse OCL into diagnostics with exact places. */
public final class ProblemCollector extends AbstractProblemHandler {

  /** Message of Eclipse OCL for any feature after a type name, since Ecore has no static ones. */
  private static final Pattern NON_STATIC =
      Pattern.compile("Static (?:call|reference) to non-static (?:operation|attribute) \"(.*)\"");

  private final SourceRange range;
  private final Predicate<String> isStatic;
  private final int prefix;
  private final List<Diagnostic> problems;
  private boolean failed;
  private boolean syntaxErrorFound;

  /**
   * Collects the problems of one parse.
   *
   * @param range the parsed text
   * @param prefix the number of characters before it in the parser's input
   * @param isStatic tells whether a definition of a name is static
   */
  public ProblemCollector(
      SourceRange range, int prefix, Predicate<String> isStatic, List<Diagnostic> problems) {
    super(null);
    this.isStatic = isStatic;
    this.range = range;
    this.prefix = prefix;
    this.problems = problems;
  }

  /** Returns whether the parsed text has a character at the parser's offset. */
  boolean isAt(char character, int startOffset) {
    int offset = offset(startOffset);
    return offset < range.end() && range.source().text().charAt(offset) == character;
  }

  /** Returns whether an error was reported. */
  public boolean failed() {
    return failed;
  }

  /** Records an error that is reported elsewhere. */
  void fail() {
    failed = true;
  }

  @Override
  public void handleProblem(
      Severity severity,
      Phase phase,
      String message,
      String context,
      int startOffset,
      int endOffset) {
    if (severity.getDiagnosticSeverity() < org.eclipse.emf.common.util.Diagnostic.WARNING) {
      return;
    }
    boolean error =
        severity.getDiagnosticSeverity() >= org.eclipse.emf.common.util.Diagnostic.ERROR;
    if (phase.equals(Phase.LEXER) || phase.equals(Phase.PARSER)) {
      addSyntaxProblem(error, message, startOffset);
    } else {
      add(ExpressionRules.TYPE, error, message, "", startOffset);
    }
  }

  /** Adds the first syntax problem; later ones only follow from it. */
  private void addSyntaxProblem(boolean error, String message, int startOffset) {
    // A quoted name is unusual but valid; an unknown one is a separate error.
    if (!syntaxErrorFound && !message.startsWith("Usage of non-standard quoted")) {
      syntaxErrorFound = error;
      String words = SyntaxTexts.message(message);
      add(ExpressionRules.SYNTAX, error, words, SyntaxTexts.hint(words), startOffset);
    }
  }

  public void add(Rule rule, boolean error, String message, String hint, int startOffset) {
    Matcher nonStatic = NON_STATIC.matcher(message);
    if (nonStatic.matches() && isStatic.test(nonStatic.group(1))) {
      return;
    }
    SourceLocation location = range.source().at(offset(startOffset));
    Diagnostic problem =
        Diagnostic.of(rule, message, location)
            .withSeverity(
                error
                    ? dev.eventchain.diagnostics.Severity.ERROR
                    : dev.eventchain.diagnostics.Severity.WARNING);
    failed |= error;
    if (!problems.contains(problem.withHint(hint))) {
      problems.add(problem.withHint(hint));
    }
  }

  private int offset(int startOffset) {
    return startOffset < prefix
        ? range.start()
        : Math.min(range.end(), startOffset - prefix + range.start());
  }
}
