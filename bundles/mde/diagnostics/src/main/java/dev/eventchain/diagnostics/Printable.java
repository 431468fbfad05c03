package dev.eventchain.diagnostics;

import java.util.Locale;

/**
 * Sanitizer of text from models and other programs before it is shown. Such text must neither
 * control a terminal nor pass for output of this program.
 */
public final class Printable {

  private static final int LONGEST_LINE = 400;
  private static final char REPLACEMENT = '\uFFFD';

  private Printable() {}

  /**
   * Returns text for a terminal, where no line after the first passes for output of this program.
   */
  public static String lines(String text) {
    return clean(text).replace("\n", "\n    | ");
  }

  /**
   * Returns output of another program as part of a sentence: one line, cut beyond 400 characters.
   */
  public static String line(String text) {
    String stripped = text.strip();
    int most = Math.min(stripped.length(), LONGEST_LINE);
    String shown = clean(stripped.substring(0, most)).replace("\n", "\\n").replace('\t', ' ');
    return most < stripped.length() ? shown + "\u2026" : shown;
  }

  /** Returns text with control characters and misleading characters as escapes. */
  public static String clean(String text) {
    StringBuilder result = new StringBuilder(text.length());
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      if (isHarmless(text, i) || c == '\n') {
        result.append(c);
      } else {
        result.append(String.format(Locale.ROOT, c < 0x100 ? "\\x%02x" : "\\u%04x", (int) c));
      }
    }
    return result.toString();
  }

  /**
   * Returns a part of a source line, cleaned as by {@link #clean} but with each character in its
   * place.
   */
  public static String excerpt(String line) {
    StringBuilder result = new StringBuilder(line.length());
    for (int i = 0; i < line.length(); i++) {
      result.append(isHarmless(line, i) ? line.charAt(i) : REPLACEMENT);
    }
    return result.toString();
  }

  private static boolean isHarmless(String text, int index) {
    char c = text.charAt(index);
    boolean steers = c != '\t' && (Character.isISOControl(c) || isDirection(c));
    return !steers && !isLoneSurrogate(text, index);
  }

  /** Returns whether there is an unpaired surrogate, which no file can hold. */
  private static boolean isLoneSurrogate(String text, int index) {
    char c = text.charAt(index);
    if (Character.isHighSurrogate(c)) {
      return index + 1 == text.length() || !Character.isLowSurrogate(text.charAt(index + 1));
    }
    return Character.isLowSurrogate(c)
        && (index == 0 || !Character.isHighSurrogate(text.charAt(index - 1)));
  }

  /** Returns whether a character reverses the direction of text, or breaks a line invisibly. */
  private static boolean isDirection(char c) {
    return (c >= '\u202A' && c <= '\u202E')
        || (c >= '\u2066' && c <= '\u2069')
        || c == '\u2028'
        || c == '\u2029'
        || c == '\u200E'
        || c == '\u200F'
        || c == '\u061C';
  }
}
