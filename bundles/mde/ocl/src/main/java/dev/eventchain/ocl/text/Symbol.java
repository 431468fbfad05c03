package dev.eventchain.ocl.text;

import java.util.ArrayList;
import java.util.List;

/**
 * A symbol of OCL text as a formatter sees it: with its comments, and with numbers, quoted names
 * and signs of several characters as one.
 *
 * @param kind END for what follows the last symbol, which has no text
 * @param text without white space at its end
 * @param gap the white space before it
 * @param start the offset of its first character
 */
public record Symbol(Kind kind, String text, String gap, int start) {

  /** Kinds of symbols. */
  public enum Kind {
    NAME,
    NUMBER,
    STRING,
    SIGN,
    COMMENT,
    END
  }

  private static final List<String> SIGNS = List.of("?->", "<>", "<=", ">=", "..", "?.");

  /** Splits a text into symbols; accepts any text. */
  public static List<Symbol> in(String text) {
    List<Symbol> symbols = new ArrayList<>();
    int gap = 0;
    int end;
    for (int i = 0; i < text.length(); i = end) {
      if (Character.isWhitespace(text.charAt(i))) {
        end = Lexer.end(text, i, text.length());
      } else {
        end = end(text, i);
        String written = text.substring(i, end).stripTrailing();
        symbols.add(new Symbol(kind(text, i), written, text.substring(gap, i), i));
        gap = i + written.length();
      }
    }
    symbols.add(new Symbol(Kind.END, "", text.substring(gap), text.length()));
    return symbols;
  }

  private static Kind kind(String text, int start) {
    char c = text.charAt(start);
    if (Lexer.isBlank(text, start)) {
      return Kind.COMMENT;
    } else if (c == '\'' || c == '"') {
      return Kind.STRING;
    } else if (Character.isDigit(c)) {
      return Kind.NUMBER;
    }
    return Character.isJavaIdentifierPart(c) ? Kind.NAME : Kind.SIGN;
  }

  private static int end(String text, int start) {
    if (Character.isDigit(text.charAt(start))) {
      return Lexer.endOfNumber(text, start, text.length());
    }
    for (String sign : SIGNS) {
      if (text.startsWith(sign, start)) {
        return start + sign.length();
      }
    }
    int end = Lexer.end(text, start, text.length());
    boolean quoted = end < text.length() && text.charAt(end) == '\'';
    return quoted && text.startsWith("_", start) && end == start + 1
        ? Lexer.end(text, end, text.length())
        : end;
  }

  /** Returns whether it is a sign or a word with this text. */
  public boolean is(String other) {
    return text.equals(other) && (kind == Kind.SIGN || kind == Kind.NAME);
  }

  /** Returns whether it is the first of its line. */
  public boolean isFirstOfLine() {
    return start == gap.length() || gap.indexOf('\n') >= 0 || gap.indexOf('\r') >= 0;
  }
}
