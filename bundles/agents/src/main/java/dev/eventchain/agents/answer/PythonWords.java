package dev.eventchain.agents.answer;

import java.util.Map;

/** The constants of Python, which models write into JSON that they think of as a Python value. */
final class PythonWords {
  /** Each as long as the other, so that the places of all that follows stay the same. */
  private static final Map<String, String> WORDS =
      Map.of("True", "true", "False", "false", "None", "null");

  private PythonWords() {}

  /** The same text with the constants of JSON, but for what is in texts and comments. */
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

  /** Where the text, the comment, the word or the single character that begins here ends. */
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
