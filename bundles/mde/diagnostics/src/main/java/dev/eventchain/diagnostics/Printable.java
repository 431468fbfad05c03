package dev.eventchain.diagnostics;

import java.util.Locale;

/**
 * Makes what comes from models and foreign programs harmless where it is shown: it must not steer a
 * terminal, nor pass for something that this program says.
 */
public final class Printable {

  private static final int LONGEST_LINE = 400;
  private static final char REPLACEMENT = '\uFFFD';

  private Printable() {}

  /** For a terminal: no line after the first can be taken for one of ours. */
  static String lines(String text) {
    return clean(text).replace("\n", "\n    | ");
  }

  /** What a foreign program said, as a part of a sentence: one line, cut beyond 400 characters. */
  public static String line(String text) {
    String stripped = text.strip();
    int most = Math.min(stripped.length(), LONGEST_LINE);
    String shown = clean(stripped.substring(0, most)).replace("\n", "\\n").replace('\t', ' ');
    return most < stripped.length() ? shown + "\u2026" : shown;
  }

  /** With control characters, and those that make text read as something else, as escapes. */
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

  /** A part of a source line: as {@link #clean}, but each character stays where it is. */
  static String excerpt(String line) {
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

  /** Half a character, which no file can hold. */
  private static boolean isLoneSurrogate(String text, int index) {
    char c = text.charAt(index);
    if (Character.isHighSurrogate(c)) {
      return index + 1 == text.length() || !Character.isLowSurrogate(text.charAt(index + 1));
    }
    return Character.isLowSurrogate(c)
        && (index == 0 || !Character.isHighSurrogate(text.charAt(index - 1)));
  }

  /** Characters that reverse the direction of text, or break a line invisibly. */
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
