package dev.eventchain.ocl;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import java.util.List;
import org.eclipse.ocl.lpg.AbstractProblemHandler;

/** Turns the problems that Eclipse OCL reports into diagnostics with their exact places. */
final class ProblemCollector extends AbstractProblemHandler {

  private final SourceText text;
  private final int start;
  private final int end;
  private final int prefix;
  private final List<Diagnostic> problems;
  private boolean failed;

  /**
   * Collects the problems of one parse.
   *
   * @param prefix how many characters stand in the parser's input before the part of the text that
   *     is parsed, which goes from start to end
   */
  ProblemCollector(SourceText text, int start, int end, int prefix, List<Diagnostic> problems) {
    super(null);
    this.text = text;
    this.start = start;
    this.end = end;
    this.prefix = prefix;
    this.problems = problems;
  }

  /** Whether an error was reported. */
  boolean failed() {
    return failed;
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
    boolean syntax = phase.equals(Phase.LEXER) || phase.equals(Phase.PARSER);
    // The first errors tell; what follows a syntax error is mostly its echo.
    boolean error =
        severity.getDiagnosticSeverity() >= org.eclipse.emf.common.util.Diagnostic.ERROR;
    add(syntax ? "ocl.syntax" : "ocl.type", error, message, startOffset);
  }

  void add(String id, boolean error, String message, int startOffset) {
    int offset = startOffset < prefix ? start : Math.min(end, startOffset - prefix + start);
    Diagnostic problem =
        error
            ? Diagnostic.error(id, message, text.at(offset))
            : Diagnostic.warning(id, message, text.at(offset));
    failed |= error;
    if (!problems.contains(problem)) {
      problems.add(problem);
    }
  }
}
