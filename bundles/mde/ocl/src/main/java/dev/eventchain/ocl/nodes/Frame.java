package dev.eventchain.ocl.nodes;

import dev.eventchain.ocl.tree.InvalidOrigin;
import java.util.HashMap;
import java.util.Map;

/** The variables of one evaluation of a lowered expression, or of one call of a definition. */
public final class Frame {

  private static final Object[] NO_SLOTS = {};

  final Run run;
  final Object[] slots;

  /** The frame of the outermost expression, perhaps this one. */
  private final Frame outermost;

  private LibraryCalls calls;

  /** The origins of invalid variables; null if not recorded. */
  private Map<Integer, InvalidOrigin> origins;

  /** Creates the frame of an expression. */
  Frame(Run run, int size) {
    this.run = run;
    this.slots = size == 0 ? NO_SLOTS : new Object[size];
    this.outermost = this;
  }

  /** Creates the frame of a called definition. */
  Frame(Frame caller, int size) {
    this.run = caller.run;
    this.slots = new Object[size];
    this.outermost = caller.outermost;
  }

  /** Returns the evaluation that the frame belongs to. */
  public Run run() {
    return run;
  }

  /** Replays the earlier results of library calls. */
  public void replay(LibraryCalls before) {
    before.replay();
    calls = before;
  }

  /** Records the latest origin as that of an invalid variable. */
  void keepOrigin(int slot) {
    if (origins == null) {
      origins = new HashMap<>();
    }
    origins.put(slot, run.origin());
  }

  /** Returns the origin of an invalid variable; null if unknown. */
  InvalidOrigin originOf(int slot) {
    return origins == null ? null : origins.get(slot);
  }

  /** Returns the results of library calls, recorded to explain invalid values. */
  public LibraryCalls calls() {
    if (outermost.calls == null) {
      outermost.calls = new LibraryCalls();
    }
    return outermost.calls;
  }
}
