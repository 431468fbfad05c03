package dev.eventchain.ocl;

import org.eclipse.ocl.EvaluationHaltedException;

/** A node whose work may throw, which makes the value invalid. */
abstract class GuardedNode extends Node {

  @Override
  final Object evaluate(Frame frame) {
    try {
      return compute(frame);
    } catch (EvaluationHaltedException e) {
      throw e;
    } catch (RuntimeException e) {
      return INVALID;
    }
  }

  abstract Object compute(Frame frame);
}
