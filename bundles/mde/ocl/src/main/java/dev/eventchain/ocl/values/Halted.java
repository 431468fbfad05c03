package dev.eventchain.ocl.values;

import dev.eventchain.ocl.evaluation.Invalid;

/** Ends an evaluation that goes beyond a limit. */
public final class Halted extends RuntimeException {

  private static final long serialVersionUID = 1L;

  private final Invalid.Kind kind;

  public Halted(String reason, Invalid.Kind kind) {
    super(reason);
    this.kind = kind;
  }

  /** Which limit it was. */
  public Invalid.Kind kind() {
    return kind;
  }
}
