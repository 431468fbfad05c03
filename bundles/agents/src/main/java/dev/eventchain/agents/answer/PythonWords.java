package dev.eventchain.agents.answer;

import java.util.Map;

/** The constants of Python, which models use in JSON by mistake. */
final class PythonWords {
  /** Words and replacements of equal length, which keeps all offsets. */
  private static final Map<String, String> WORDS =
      Map.of("True", "true", "False", "false", "None", "null");

  private PythonWords() {}

  /** Returns the text with the constants of JSON, except in strings and comments. */
  static String replaced(String text) {
    StringBuilder out = new StringBuilder(text);
    int at = 0;
    while (at < text.length()) {
      int end = end(text, at);
      String word = WORDS.get(text.substring(at, end));
      if (word != null) {
        out.replace(at, end, word);
      }
      at = end;
    }
    return out.toString();
  }

  /** Returns the end of the string, comment, word or single character that starts here. */
  private static int end(String text, int start) {
    char first = text.charAt(start);
    if (first == '"' || first == '\'') {
      return endOfQuoted(text, start);
    }
    if (first == '#' || text.startsWith("//", start)) {
      return after(text, "\n", start);
    }
    if (text.startsWith("/*", start)) {
      return after(text, "*/", start + 2);
    }
    int end = start;
    while (end < text.length() && Character.isJavaIdentifierPart(text.charAt(end))) {
      end++;
    }
    return Math.max(end, start + 1);
  }

  private static int endOfQuoted(String text, int start) {
    int at = start + 1;
    while (at < text.length() && text.charAt(at) != text.charAt(start)) {
      at += text.charAt(at) == '\\' ? 2 : 1;
    }
    return Math.min(at + 1, text.length());
  }

  private static int after(String text, String mark, int start) {
    int found = text.indexOf(mark, start);
    return found < 0 ? text.length() : found + mark.length();
  }
}
