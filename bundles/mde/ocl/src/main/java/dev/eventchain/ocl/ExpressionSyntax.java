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
import dev.eventchain.ocl.text.ExpressionRules;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The syntax of expressions and definitions, whatever metamodels they are about. Not thread-safe.
 */
public final class ExpressionSyntax {

  private static final String EXPRESSION_PREFIX = "inv:\n";

  private static final String UNREADABLE = "This cannot be read as OCL.";

  private final OclEnvironment environment =
      new OclEnvironmentFactory(new PackageIndex(List.of()), Dialect.STANDARD).root();

  /** Returns whether an expression has no syntax error. */
  public boolean isExpression(SourceRange text) {
    return errorOfExpression(text).isEmpty();
  }

  /** Returns the first syntax error of an expression; empty if it has none. */
  public Optional<Diagnostic> errorOfExpression(SourceRange text) {
    return error(text, EXPRESSION_PREFIX);
  }

  /** Returns the first syntax error of a definition, from {@code def} or {@code static} on. */
  public Optional<Diagnostic> errorOfDefinition(SourceRange text) {
    return error(text, "");
  }

  private Optional<Diagnostic> error(SourceRange text, String prefix) {
    List<Diagnostic> problems = new ArrayList<>(FrequentMistakes.in(text));
    if (!problems.isEmpty()) {
      return Optional.of(problems.get(0));
    }
    ProblemCollector collector =
        new ProblemCollector(text, prefix.length(), name -> false, problems);
    environment.setProblemHandler(collector);
    boolean isSound;
    try {
      // Eclipse OCL ends a comment at line feeds only.
      String input = prefix + text.text().replace('\r', '\n');
      isSound =
          new OclAnalyzer(environment, input).parseConcreteSyntax() != null && !collector.failed();
    } catch (RuntimeException | StackOverflowError e) {
      isSound = false;
    }
    return isSound
        ? Optional.empty()
        : problems.stream()
            .findFirst()
            .or(
                () ->
                    Optional.of(
                        Diagnostic.of(ExpressionRules.SYNTAX, UNREADABLE, text.location())));
  }
}
