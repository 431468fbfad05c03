package dev.eventchain.editing;

/**
 * A range of a text.
 *
 * @param start the position before the first character
 * @param end the position after the last character
 */
public record TextRange(TextPosition start, TextPosition end) {

  /** Returns an empty range. */
  public static TextRange at(TextPosition position) {
    return new TextRange(position, position);
  }

  /** Returns whether a position is in the range or at one of its ends. */
  public boolean touches(TextPosition position) {
    return start.compareTo(position) <= 0 && position.compareTo(end) <= 0;
  }
}
