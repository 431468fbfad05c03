package dev.eventchain.ocl.values;

import dev.eventchain.ocl.evaluation.Invalid;

/** Thrown to end an evaluation that exceeds a limit. */
public final class Halted extends RuntimeException {

  private static final long serialVersionUID = 1L;

  private final Invalid.Kind kind;

  public Halted(String reason, Invalid.Kind kind) {
    super(reason);
    this.kind = kind;
  }

  /** Returns the kind of the limit. */
  public Invalid.Kind kind() {
    return kind;
  }
}
