package dev.eventchain.ocl.nodes;

import dev.eventchain.ocl.values.Halted;

/** A node whose work may throw, which makes the value invalid. */
abstract class GuardedNode extends Node {

  @Override
  final Object evaluate(Frame frame) {
    try {
      return compute(frame);
    } catch (Halted e) {
      throw e;
    } catch (RuntimeException e) {
      if (tells(e)) {
        frame.run.fail(e);
      }
      return INVALID;
    }
  }

  /**
   * Whether an exception says more than the value does that the work was done on. That a text is
   * not a number can be seen; which classes of Java do not fit is of no use to anybody.
   */
  boolean tells(RuntimeException e) {
    return !(e instanceof ClassCastException || e instanceof NumberFormatException);
  }

  abstract Object compute(Frame frame);
}
