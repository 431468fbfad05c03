package dev.eventchain.m2t.syntax;

/** String literals of OCL, as far as finding their end goes. */
final class Quotes {
  private Quotes() {}

  /**
   * The closing quote of the literal that opens at an offset.
   *
   * @return -1 if the literal does not end on its line
   */
  static int close(String text, int open, int limit) {
    for (int i = open + 1; i < limit; i++) {
      char c = text.charAt(i);
      if (c == '\\') {
        i++;
      } else if (c == '\'') {
        return i;
      } else if (c == '\n') {
        return -1;
      }
    }
    return -1;
  }

  static int endOfLine(String text, int from) {
    int end = text.indexOf('\n', from);
    return end < 0 ? text.length() : end;
  }
}
