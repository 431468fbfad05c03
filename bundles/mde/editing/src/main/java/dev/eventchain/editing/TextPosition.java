package dev.eventchain.editing;

import java.util.Comparator;

/**
 * A position between two characters of a text.
 *
 * @param line the line, from 0; lines end with LF, CRLF or CR
 * @param column the number of UTF-16 units before it on its line
 */
public record TextPosition(int line, int column) implements Comparable<TextPosition> {

  private static final Comparator<TextPosition> ORDER =
      Comparator.comparingInt(TextPosition::line).thenComparingInt(TextPosition::column);

  @Override
  public int compareTo(TextPosition other) {
    return ORDER.compare(this, other);
  }
}
