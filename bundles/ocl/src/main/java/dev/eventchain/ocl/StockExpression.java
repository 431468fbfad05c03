package dev.eventchain.ocl;

import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.ocl.expressions.OCLExpression;

/** A part of an expression that is not lowered: {@link Evaluator} evaluates it. */
final class StockExpression extends Node {

  private final ExpressionLanguage language;
  private final OCLExpression<EClassifier> expression;
  private final String[] names;
  private final int[] slots;

  /**
   * Makes the node.
   *
   * @param names the variables that can be seen there, inner ones last
   * @param slots where their values are
   */
  StockExpression(
      ExpressionLanguage language,
      OCLExpression<EClassifier> expression,
      String[] names,
      int[] slots) {
    this.language = language;
    this.expression = expression;
    this.names = names;
    this.slots = slots;
  }

  @Override
  Object evaluate(Frame frame) {
    ValueStack stack = frame.run.values();
    int height = stack.size();
    for (int i = 0; i < names.length; i++) {
      stack.push(names[i], frame.slots[slots[i]]);
    }
    try {
      return language.evaluator(frame.run, frame.calls()).visitExpression(expression);
    } finally {
      stack.truncate(height);
    }
  }
}
