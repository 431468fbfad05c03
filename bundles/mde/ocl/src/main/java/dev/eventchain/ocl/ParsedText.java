package dev.eventchain.ocl;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.ocl.parse.OclAnalyzer;
import dev.eventchain.ocl.parse.OclEnvironment;
import dev.eventchain.ocl.parse.ProblemCollector;
import dev.eventchain.ocl.parse.SyntaxTexts;
import dev.eventchain.ocl.text.ExpressionRules;
import dev.eventchain.ocl.tree.InvalidOrigin;
import java.util.List;
import java.util.Optional;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.ocl.ecore.Constraint;
import org.eclipse.ocl.expressions.OCLExpression;
import org.eclipse.ocl.parser.ValidationVisitor;

/**
 * Result of parsing a text.
 *
 * @param body the tree, perhaps with placeholders for what was not understood; {@code null} if
 *     there is none
 * @param failed true if there is an error
 */
record ParsedText(OCLExpression<EClassifier> body, boolean failed) {

  private static final ParsedText UNREADABLE = new ParsedText(null, true);

  /**
   * Parses a text.
   *
   * @param prefix what the parser reads before it
   * @param suffix what the parser reads after it
   * @param environment the names that it can use
   * @param root the environment of the language
   * @param problems the list to add all errors and warnings to
   */
  static ParsedText read(
      SourceRange range,
      String prefix,
      String suffix,
      OclEnvironment environment,
      OclEnvironment root,
      List<Diagnostic> problems) {
    ProblemCollector collector =
        new ProblemCollector(range, prefix.length(), root::hasStatic, problems);
    environment.setProblemHandler(collector);
    try {
      // Eclipse OCL ends a comment at line feeds only.
      String input = prefix + range.text().replace('\r', '\n') + suffix;
      OclAnalyzer analyzer = new OclAnalyzer(environment, input);
      analyzer.setCharacterOffset(range.start() - prefix.length());
      Constraint constraint = analyzer.parseInvOrDefCS();
      if (constraint == null) {
        return UNREADABLE;
      } else if (collector.failed()) {
        return new ParsedText(bodyOf(constraint), true);
      }
      OCLExpression<EClassifier> body = bodyOf(constraint);
      body.accept(ValidationVisitor.getInstance(environment));
      body.eAdapters().add(new InvalidOrigin.Source(range.source()));
      return new ParsedText(body, collector.failed());
    } catch (RuntimeException | StackOverflowError e) {
      collector.add(ExpressionRules.SYNTAX, true, "The expression " + SyntaxTexts.unread(e), "", 0);
      return UNREADABLE;
    } finally {
      root.clean();
    }
  }

  private static OCLExpression<EClassifier> bodyOf(Constraint constraint) {
    return constraint.getSpecification() == null
        ? null
        : constraint.getSpecification().getBodyExpression();
  }

  /** Returns the tree if it has no error. */
  Optional<OCLExpression<EClassifier>> valid() {
    return failed ? Optional.empty() : Optional.ofNullable(body);
  }

  /** Returns what was understood. */
  Optional<OCLExpression<EClassifier>> understood() {
    return Optional.ofNullable(body);
  }
}
