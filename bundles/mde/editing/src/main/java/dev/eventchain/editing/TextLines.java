package dev.eventchain.editing;

import java.util.Arrays;

/** The lines of a text: converts offsets into positions and back. Immutable. */
public final class TextLines {

  private final String text;
  private final int[] starts;

  /** Finds the lines of a text. */
  public TextLines(String text) {
    this.text = text;
    int[] found = new int[16];
    int count = 1;
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      if (c == '\n' || (c == '\r' && !text.startsWith("\n", i + 1))) {
        if (count == found.length) {
          found = Arrays.copyOf(found, count * 2);
        }
        found[count++] = i + 1;
      }
    }
    this.starts = Arrays.copyOf(found, count);
  }

  /** Returns the number of lines, at least 1. */
  public int count() {
    return starts.length;
  }

  /** Returns the position of an offset; one outside the text counts as its nearest end. */
  public TextPosition position(int offset) {
    int inside = Math.max(0, Math.min(offset, text.length()));
    int found = Arrays.binarySearch(starts, inside);
    int line = found >= 0 ? found : -found - 2;
    return new TextPosition(line, inside - starts[line]);
  }

  /** Returns the range between two offsets. */
  public TextRange range(int start, int end) {
    return new TextRange(position(start), position(end));
  }

  /** Returns the offset of a position; a column beyond its line counts as the line's end. */
  public int offset(TextPosition position) {
    if (position.line() < 0) {
      return 0;
    } else if (position.line() >= starts.length) {
      return text.length();
    }
    int start = starts[position.line()];
    return Math.max(start, Math.min(start + position.column(), end(position.line())));
  }

  /** Returns the offset of a line's end, before its line break. */
  private int end(int line) {
    if (line + 1 == starts.length) {
      return text.length();
    }
    int end = starts[line + 1] - 1;
    return end > starts[line] && text.charAt(end) == '\n' && text.charAt(end - 1) == '\r'
        ? end - 1
        : end;
  }
}
