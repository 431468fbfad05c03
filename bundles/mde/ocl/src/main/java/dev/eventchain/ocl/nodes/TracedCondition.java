package dev.eventchain.ocl.nodes;

import dev.eventchain.ocl.tree.InvalidOrigin;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.ocl.expressions.OCLExpression;

/** The Boolean body of a loop, which records a value that is not a Boolean. */
public final class TracedCondition extends Node {
  private final OCLExpression<EClassifier> loop;
  private final Node body;

  public TracedCondition(OCLExpression<EClassifier> loop, Node body) {
    this.loop = loop;
    this.body = body;
  }

  @Override
  Object evaluate(Frame frame) {
    Object value = body.evaluate(frame);
    if (value == null || value == INVALID || value instanceof Boolean) {
      return value;
    }
    String detail = "is " + InvalidOrigin.described(value) + " for an element, not a Boolean";
    frame.run.setOrigin(new InvalidOrigin(loop, value, detail, null));
    return INVALID;
  }
}
