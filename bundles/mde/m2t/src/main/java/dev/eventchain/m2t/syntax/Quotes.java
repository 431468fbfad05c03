package dev.eventchain.m2t.syntax;

/** Search for the end of OCL string literals. */
final class Quotes {
  private Quotes() {}

  /**
   * Returns the offset of the closing quote of a literal.
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
