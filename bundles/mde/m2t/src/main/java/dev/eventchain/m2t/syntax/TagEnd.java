package dev.eventchain.m2t.syntax;

/**
 * End of a tag. Brackets inside quotes do not count; another opening bracket or the end of a line
 * inside quotes means that the tag is not closed.
 *
 * @param found true if there is a closing bracket
 * @param offset the offset of the closing bracket, otherwise of the continuation
 * @param openQuote the offset of the unclosed quote, or -1
 */
record TagEnd(boolean found, int offset, int openQuote) {

  static TagEnd find(String text, int from) {
    int position = from;
    while (position < text.length()) {
      char c = text.charAt(position);
      if (c == ']') {
        return new TagEnd(true, position, -1);
      }
      if (c == '[') {
        return new TagEnd(false, position, -1);
      }
      if (c == '\'') {
        int close = Quotes.close(text, position, text.length());
        if (close < 0) {
          return new TagEnd(false, Quotes.endOfLine(text, position), position);
        }
        position = close;
      }
      position++;
    }
    return new TagEnd(false, Quotes.endOfLine(text, from), -1);
  }
}
