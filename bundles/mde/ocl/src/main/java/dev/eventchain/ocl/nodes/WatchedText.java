package dev.eventchain.ocl.nodes;

/** A text for a regular expression, to which the time limit of an evaluation applies, too. */
record WatchedText(CharSequence text, Run run) implements CharSequence {

  /** Regular expressions that never seem to end need a text of some length for that. */
  private static final int SHORT = 20;

  /** The text itself if it is too short for that. */
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
