package dev.eventchain.diagnostics;

import java.util.Objects;

/**
 * A range of a source text, with a reference to the text to locate it.
 *
 * @param source the whole text
 * @param start the offset of the first character
 * @param end the offset after the last character, from start to the length of the text
 */
public record SourceRange(SourceText source, int start, int end) {

  /** Refuses ranges outside the text. */
  public SourceRange {
    Objects.checkFromToIndex(start, end, source.text().length());
  }

  /** Returns the text of the range. */
  public String text() {
    return source.text().substring(start, end);
  }

  /** Returns the location of the first character. */
  public SourceLocation location() {
    return source.at(start);
  }

  /** Returns whether the range is empty; white space counts as content. */
  public boolean isEmpty() {
    return start == end;
  }

  /** Returns the range without white space at its ends. */
  public SourceRange strip() {
    String text = source.text();
    int from = start;
    int to = end;
    while (from < to && Character.isWhitespace(text.charAt(from))) {
      from++;
    }
    while (to > from && Character.isWhitespace(text.charAt(to - 1))) {
      to--;
    }
    return new SourceRange(source, from, to);
  }
}
