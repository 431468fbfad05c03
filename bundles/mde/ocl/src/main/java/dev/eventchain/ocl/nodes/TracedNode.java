package dev.eventchain.ocl.nodes;

import dev.eventchain.ocl.tree.InvalidOrigin;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.ocl.expressions.CollectionKind;
import org.eclipse.ocl.expressions.OCLExpression;

/**
 * A node that records its expression and the source of that, if it is the innermost invalid one.
 * Used only to explain invalid values.
 */
public final class TracedNode extends Node {

  private final OCLExpression<EClassifier> expression;
  private final Node node;

  /** The source of the expression; null if it has none. */
  private final Node subject;

  public TracedNode(OCLExpression<EClassifier> expression, Node node, Node subject) {
    this.expression = expression;
    this.node = node;
    this.subject = subject;
  }

  @Override
  Object evaluate(Frame frame) {
    InvalidOrigin before = begin(frame.run);
    return end(node.evaluate(frame), before, frame);
  }

  @Override
  Object read(Frame frame) {
    InvalidOrigin before = begin(frame.run);
    return end(node.read(frame), before, frame);
  }

  @Override
  CollectionKind kindOfElements() {
    return node.kindOfElements();
  }

  private static InvalidOrigin begin(Run run) {
    run.step();
    InvalidOrigin before = run.origin();
    run.setOrigin(null);
    return before;
  }

  private Object end(Object result, InvalidOrigin before, Frame frame) {
    Run run = frame.run;
    Run.Failure failure = run.takeFailure();
    if (result != INVALID) {
      run.setOrigin(before);
    } else if (run.origin() == null) {
      Object source = subject == null ? null : subject.evaluate(frame);
      run.setOrigin(new InvalidOrigin(expression, source, failure.detail(), failure.cause()));
    }
    return result;
  }
}
