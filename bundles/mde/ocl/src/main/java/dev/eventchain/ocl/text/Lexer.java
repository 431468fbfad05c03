package dev.eventchain.ocl.text;

/** Finds the tokens of OCL text, as needed to distinguish code from comments and strings. */
public final class Lexer {

  private Lexer() {}

  /**
   * Returns the end of the token at an offset: a comment, a string, a name, a number, white space,
   * an arrow, a double colon, or else one character.
   */
  public static int end(String text, int start, int limit) {
    char c = text.charAt(start);
    if (text.startsWith("--", start)) {
      return endOfLine(text, start, limit);
    } else if (text.startsWith("/*", start)) {
      int end = text.indexOf("*/", start + 2);
      return end < 0 ? limit : Math.min(end + 2, limit);
    } else if (c == '\'' || c == '"') {
      return endOfString(text, start, limit, c);
    } else if (Character.isJavaIdentifierPart(c)) {
      return endOfRun(text, start, limit, Character::isJavaIdentifierPart);
    } else if (Character.isWhitespace(c)) {
      return endOfRun(text, start, limit, Character::isWhitespace);
    } else if (text.startsWith("->", start) || text.startsWith("::", start)) {
      return Math.min(start + 2, limit);
    }
    return start + 1;
  }

  /**
   * Returns the end of the number at an offset, with its fraction and exponent: {@code 1.5e2} is
   * one, {@code 1..2} begins with {@code 1}.
   */
  public static int endOfNumber(String text, int start, int limit) {
    int end = endOfRun(text, start, limit, Character::isDigit);
    if (end + 1 < limit && text.charAt(end) == '.' && Character.isDigit(text.charAt(end + 1))) {
      end = endOfRun(text, end + 1, limit, Character::isDigit);
    }
    if (end < limit && "eE".indexOf(text.charAt(end)) >= 0) {
      int exponent = end + 1;
      exponent += exponent < limit && "+-".indexOf(text.charAt(exponent)) >= 0 ? 1 : 0;
      if (exponent < limit && Character.isDigit(text.charAt(exponent))) {
        return endOfRun(text, exponent, limit, Character::isDigit);
      }
    }
    return end;
  }

  /** Returns the end of a line: before a line feed or a carriage return. */
  private static int endOfLine(String text, int start, int limit) {
    int end = start;
    while (end < limit && text.charAt(end) != '\n' && text.charAt(end) != '\r') {
      end++;
    }
    return end;
  }

  /** Returns whether a comment between these offsets lacks its end mark. */
  static boolean isUnclosedComment(String text, int start, int end) {
    return text.startsWith("/*", start) && text.indexOf("*/", start + 2) != end - 2;
  }

  private static int endOfString(String text, int start, int limit, char quote) {
    for (int i = start + 1; i < limit; i++) {
      char c = text.charAt(i);
      if (c == '\\' && !text.startsWith("\n", i + 1) && !text.startsWith("\r", i + 1)) {
        i++;
      } else if (c == quote) {
        return i + 1;
      } else if (c == '\n' || c == '\r') {
        return i; // Strings do not span lines: what follows an unclosed one is code again.
      }
    }
    return limit;
  }

  private static int endOfRun(
      String text, int start, int limit, java.util.function.IntPredicate part) {
    int end = start + 1;
    while (end < limit && part.test(text.charAt(end))) {
      end++;
    }
    return end;
  }

  /** Returns whether white space or a comment starts at an offset. */
  public static boolean isBlank(String text, int start) {
    return Character.isWhitespace(text.charAt(start))
        || text.startsWith("--", start)
        || text.startsWith("/*", start);
  }
}
