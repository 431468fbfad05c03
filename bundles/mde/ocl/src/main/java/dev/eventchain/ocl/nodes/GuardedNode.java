package dev.eventchain.ocl.nodes;

import dev.eventchain.ocl.values.Halted;

/** A node whose computation may throw, which makes the value invalid. */
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
   * Returns whether the message of an exception helps users. That a text is not a number is visible
   * from the value; the names of incompatible Java classes are useless.
   */
  boolean tells(RuntimeException e) {
    return !(e instanceof ClassCastException || e instanceof NumberFormatException);
  }

  abstract Object compute(Frame frame);
}
