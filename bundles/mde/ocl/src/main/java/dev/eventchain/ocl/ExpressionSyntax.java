package dev.eventchain.ocl;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.ocl.dialect.Dialect;
import dev.eventchain.ocl.metamodel.PackageIndex;
import dev.eventchain.ocl.parse.FrequentMistakes;
import dev.eventchain.ocl.parse.OclAnalyzer;
import dev.eventchain.ocl.parse.OclEnvironment;
import dev.eventchain.ocl.parse.OclEnvironmentFactory;
import dev.eventchain.ocl.parse.ProblemCollector;
import java.util.ArrayList;
import java.util.List;

/**
 * The syntax of expressions and definitions, whatever metamodels they are about. Not thread-safe.
 */
public final class ExpressionSyntax {

  private static final String EXPRESSION_PREFIX = "inv:\n";

  private final OclEnvironment environment =
      new OclEnvironmentFactory(new PackageIndex(List.of()), Dialect.STANDARD).root();

  /** Returns whether an expression has no syntax error. */
  public boolean isExpression(SourceRange text) {
    return isSound(text, EXPRESSION_PREFIX);
  }

  /** Returns whether a definition, from {@code def} or {@code static} on, has no syntax error. */
  public boolean isDefinition(SourceRange text) {
    return isSound(text, "");
  }

  private boolean isSound(SourceRange text, String prefix) {
    List<Diagnostic> problems = FrequentMistakes.in(text);
    if (!problems.isEmpty()) {
      return false;
    }
    ProblemCollector collector =
        new ProblemCollector(text, prefix.length(), name -> false, new ArrayList<>());
    environment.setProblemHandler(collector);
    try {
      // Eclipse OCL ends a comment at line feeds only.
      String input = prefix + text.text().replace('\r', '\n');
      return new OclAnalyzer(environment, input).parseConcreteSyntax() != null
          && !collector.failed();
    } catch (RuntimeException | StackOverflowError e) {
      return false;
    }
  }
}
