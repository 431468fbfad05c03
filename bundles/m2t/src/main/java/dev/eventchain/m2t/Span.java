package dev.eventchain.m2t;

/**
 * A part of a template file.
 *
 * @param start offset of the first character
 * @param end offset after the last character
 */
record Span(int start, int end) {
  String in(String text) {
    return text.substring(start, end);
  }

  /** The same part without white space at its ends. */
  Span strip(String text) {
    int from = start;
    int to = end;
    while (from < to && Character.isWhitespace(text.charAt(from))) {
      from++;
    }
    while (to > from && Character.isWhitespace(text.charAt(to - 1))) {
      to--;
    }
    return new Span(from, to);
  }

  boolean isEmpty() {
    return start == end;
  }
}
