package dev.eventchain.ocl.nodes;

import org.eclipse.ocl.expressions.CollectionKind;

/**
 * A value that depends on the model alone, such as that of {@code
 * X.allInstances()->isUnique(name)}: computed once in a run and not for each element.
 */
public final class KeptValue extends Node {

  private final Node value;

  public KeptValue(Node value) {
    this.value = value;
  }

  @Override
  Object evaluate(Frame frame) {
    return frame.run.keptValue(this, () -> value.evaluate(frame));
  }

  @Override
  CollectionKind kindOfElements() {
    return value.kindOfElements();
  }
}
