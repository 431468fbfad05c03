package dev.eventchain.ocl;

/** Ends an evaluation that goes beyond a limit. */
final class Halted extends RuntimeException {

  private static final long serialVersionUID = 1L;

  private final Invalid.Kind kind;

  Halted(String reason, Invalid.Kind kind) {
    super(reason);
    this.kind = kind;
  }

  /** Which limit it was. */
  Invalid.Kind kind() {
    return kind;
  }
}
