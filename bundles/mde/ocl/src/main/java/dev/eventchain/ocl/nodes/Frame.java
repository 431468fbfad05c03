package dev.eventchain.ocl.nodes;

import dev.eventchain.ocl.tree.InvalidOrigin;
import java.util.HashMap;
import java.util.Map;

/** The variables of one evaluation of a lowered expression, or of one call of a definition. */
public final class Frame {

  private static final Object[] NO_SLOTS = {};

  public final Run run;
  final Object[] slots;

  /** The frame of the expression; itself for an expression. */
  private final Frame outermost;

  private LibraryCalls calls;

  /** Why the variables have no values that were found to have none; null if it is not asked for. */
  private Map<Integer, InvalidOrigin> origins;

  /** For an expression. */
  Frame(Run run, int size) {
    this.run = run;
    this.slots = size == 0 ? NO_SLOTS : new Object[size];
    this.outermost = this;
  }

  /** For a definition that is called. */
  Frame(Frame caller, int size) {
    this.run = caller.run;
    this.slots = new Object[size];
    this.outermost = caller.outermost;
  }

  /** Gives the answers that libraries gave before to the same questions. */
  public void replay(LibraryCalls before) {
    before.replay();
    calls = before;
  }

  /** Notes that a variable has no value for the reason that was found last. */
  void keepOrigin(int slot) {
    if (origins == null) {
      origins = new HashMap<>();
    }
    origins.put(slot, run.origin());
  }

  /** Why a variable has no value; null if that is not known. */
  InvalidOrigin originOf(int slot) {
    return origins == null ? null : origins.get(slot);
  }

  /** What libraries answered, kept for the case that the reason of an invalid value is wanted. */
  public LibraryCalls calls() {
    if (outermost.calls == null) {
      outermost.calls = new LibraryCalls();
    }
    return outermost.calls;
  }
}
