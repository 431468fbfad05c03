package dev.eventchain.ocl.nodes;

/** A text for a regular expression that enforces the time limit of an evaluation. */
record WatchedText(CharSequence text, Run run) implements CharSequence {

  /** The length up to which matching always ends soon. */
  private static final int SHORT = 20;

  /** Returns the watched text, or the text itself if it is short. */
  static CharSequence of(CharSequence text, Run run) {
    return text.length() <= SHORT ? text : new WatchedText(text, run);
  }

  @Override
  public int length() {
    return text.length();
  }

  @Override
  public char charAt(int index) {
    run.step();
    return text.charAt(index);
  }

  @Override
  public CharSequence subSequence(int start, int end) {
    return text.subSequence(start, end);
  }

  @Override
  public String toString() {
    return text.toString();
  }
}
