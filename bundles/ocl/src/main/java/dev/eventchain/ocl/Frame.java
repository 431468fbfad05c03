package dev.eventchain.ocl;

/** The variables of one evaluation of a lowered expression, or of one call of a definition. */
final class Frame {

  private static final Object[] NO_SLOTS = {};

  final Evaluation run;
  final Object[] slots;

  /** The frame of the expression; itself for an expression. */
  private final Frame outermost;

  private LibraryCalls calls;

  /** For an expression. */
  Frame(Evaluation run, int size) {
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
  void replay(LibraryCalls before) {
    before.replay();
    calls = before;
  }

  /** What libraries answered, kept for the case that the reason of an invalid value is wanted. */
  LibraryCalls calls() {
    if (outermost.calls == null) {
      outermost.calls = new LibraryCalls();
    }
    return outermost.calls;
  }
}
