package dev.eventchain.diagnostics;

import java.util.Objects;

/**
 * A part of a text that knows the text, so that whoever is given one can say where it is.
 *
 * @param source the whole text
 * @param start the offset of the first character
 * @param end the offset after the last character, from start to the length of the text
 */
public record SourceRange(SourceText source, int start, int end) {

  /** Refuses what is not inside the text. */
  public SourceRange {
    Objects.checkFromToIndex(start, end, source.text().length());
  }

  /** What is there. */
  public String text() {
    return source.text().substring(start, end);
  }

  /** The place of its first character. */
  public SourceLocation location() {
    return source.at(start);
  }

  /** Whether nothing is there, not even white space. */
  public boolean isEmpty() {
    return start == end;
  }

  /** The same part without white space at its ends. */
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
