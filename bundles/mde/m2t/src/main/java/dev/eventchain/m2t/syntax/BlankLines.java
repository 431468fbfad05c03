package dev.eventchain.m2t.syntax;

/** Blank lines at the start and the end of a text between tags. */
final class BlankLines {
  private BlankLines() {}

  /** Returns the length of the first line with its break if it is blank, else 0. */
  static int firstOf(String text) {
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      if (c == '\n' || (c == '\r' && !text.startsWith("\n", i + 1))) {
        return i + 1;
      }
      if (!Character.isWhitespace(c)) {
        return 0;
      }
    }
    return text.length();
  }

  /**
   * Returns the length of the last line if it is blank, else 0.
   *
   * @param keepBreak false to count the line break before it, too
   */
  static int lastOf(String text, boolean keepBreak) {
    for (int i = text.length() - 1; i >= 0; i--) {
      char c = text.charAt(i);
      if (c == '\n') {
        boolean wide = i > 0 && text.charAt(i - 1) == '\r';
        return text.length() - (keepBreak ? i + 1 : wide ? i - 1 : i);
      }
      if (!Character.isWhitespace(c)) {
        return 0;
      }
    }
    return text.length();
  }

  static boolean startsWithOne(String text) {
    int end = text.indexOf(separator(text));
    return text.substring(0, end < 0 ? text.length() : end).isBlank();
  }

  static boolean endsWithOne(String text) {
    String separator = separator(text);
    int last = text.lastIndexOf(separator);
    return text.substring(last < 0 ? 0 : last + separator.length()).isBlank();
  }

  /** Returns whether a text is two line breaks, of which the first one has been taken. */
  static boolean isSecondOfTwoBreaks(String whole, String rest) {
    String separator = separator(whole);
    return whole.equals(separator + separator) && rest.equals(separator);
  }

  /** Returns what ends the lines of a text: with line breaks of several kinds, the widest one. */
  private static String separator(String text) {
    return text.contains("\r\n") ? "\r\n" : text.contains("\n") ? "\n" : "\r";
  }
}
