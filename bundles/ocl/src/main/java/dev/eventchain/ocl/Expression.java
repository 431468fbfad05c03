package dev.eventchain.ocl;

import dev.eventchain.diagnostics.SourceLocation;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.ocl.EvaluationHaltedException;
import org.eclipse.ocl.expressions.OCLExpression;

/**
 * A parsed and checked OCL expression. Immutable; several threads can evaluate it at once, each
 * with an {@link Evaluation} of its own.
 */
public final class Expression {

  private final ExpressionLanguage language;
  private final OCLExpression<EClassifier> ast;

  Expression(ExpressionLanguage language, OCLExpression<EClassifier> ast) {
    this.language = language;
    this.ast = ast;
  }

  /** The static type of the value. */
  public EClassifier type() {
    return ast.getType();
  }

  /** Where the expression stands. */
  public SourceLocation location() {
    return InvalidOrigin.locationOf(ast);
  }

  /**
   * Evaluates.
   *
   * @param run gives the values of the variables in the scope that the expression was parsed in; a
   *     variable that it does not bind is {@code null}
   * @return the value: {@code null} for OCL's null; an {@link Invalid} if there is none; numbers
   *     are {@link Integer}, {@link Long} or {@link Double}; collections are to be read only, sets
   *     and bags are walked in the order in which their elements came; a type literal gives the
   *     {@link EClassifier}
   */
  public Object evaluate(Evaluation run) {
    int height = run.values().size();
    boolean outermost = run.begin();
    try {
      Object value = language.evaluator(run).visitExpression(ast);
      return language.isInvalid(value) ? invalid(run.origin()) : value;
    } catch (EvaluationHaltedException e) {
      return new Invalid(e.getMessage(), location(), true);
    } catch (StackOverflowError e) {
      if (!outermost) {
        throw e;
      }
      return new Invalid("it recurses without end, or too deeply", location(), true);
    } finally {
      run.values().truncate(height);
      run.end();
    }
  }

  private Invalid invalid(InvalidOrigin origin) {
    return origin == null ? new Invalid("it has no value", location(), false) : origin.toInvalid();
  }

  OCLExpression<EClassifier> ast() {
    return ast;
  }
}
