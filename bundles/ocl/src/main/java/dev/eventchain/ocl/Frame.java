package dev.eventchain.ocl;

/** The variables of one evaluation of a lowered expression, or of one call of a definition. */
final class Frame {

  final Evaluation run;
  final Object[] slots;

  /** What libraries answered, kept for the case that the reason of an invalid value is wanted. */
  final LibraryCalls calls;

  /** For an expression. */
  Frame(Evaluation run, int size) {
    this.run = run;
    this.slots = new Object[size];
    this.calls = new LibraryCalls();
  }

  /** For a definition that is called. */
  Frame(Frame caller, int size) {
    this.run = caller.run;
    this.slots = new Object[size];
    this.calls = caller.calls;
  }
}
