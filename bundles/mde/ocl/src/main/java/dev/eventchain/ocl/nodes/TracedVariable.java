package dev.eventchain.ocl.nodes;

/** Variables that record why their values are invalid; used only for explanations. */
public final class TracedVariable {

  private TracedVariable() {}

  /** The value of a variable. */
  public static final class Value extends Node {
    private final int slot;
    private final Node value;

    public Value(int slot, Node value) {
      this.slot = slot;
      this.value = value;
    }

    @Override
    Object evaluate(Frame frame) {
      Object result = value.evaluate(frame);
      if (result == INVALID) {
        frame.keepOrigin(slot);
      }
      return result;
    }
  }

  /** A use of a variable. */
  public static final class Use extends Node {
    private final int slot;

    public Use(int slot) {
      this.slot = slot;
    }

    @Override
    Object evaluate(Frame frame) {
      Object value = frame.slots[slot];
      if (value == INVALID) {
        frame.run.setOrigin(frame.originOf(slot));
      }
      return value;
    }
  }
}
