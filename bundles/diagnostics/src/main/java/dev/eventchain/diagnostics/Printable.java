package dev.eventchain.diagnostics;

/** Makes what comes from models harmless where it is shown. */
final class Printable {

  private static final char REPLACEMENT = '\uFFFD';

  private Printable() {}

  /** For a terminal: what it prints must not steer it, nor pass for a finding of its own. */
  static String lines(String text) {
    return clean(text).replace("\n", "\n    ");
  }

  /** Without control characters and those that make text read as something else. */
  static String clean(String text) {
    StringBuilder result = new StringBuilder(text.length());
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      boolean harmless = c == '\n' || c == '\t' || !(Character.isISOControl(c) || isDirection(c));
      result.append(harmless && !isLoneSurrogate(text, i) ? c : REPLACEMENT);
    }
    return result.toString();
  }

  /** Half a character, which no file can hold. */
  private static boolean isLoneSurrogate(String text, int index) {
    char c = text.charAt(index);
    if (Character.isHighSurrogate(c)) {
      return index + 1 == text.length() || !Character.isLowSurrogate(text.charAt(index + 1));
    }
    return Character.isLowSurrogate(c)
        && (index == 0 || !Character.isHighSurrogate(text.charAt(index - 1)));
  }

  /** Characters that make text run the other way, so that it reads as something else. */
  private static boolean isDirection(char c) {
    return (c >= '\u202A' && c <= '\u202E')
        || (c >= '\u2066' && c <= '\u2069')
        || c == '\u200E'
        || c == '\u200F'
        || c == '\u061C';
  }
}
