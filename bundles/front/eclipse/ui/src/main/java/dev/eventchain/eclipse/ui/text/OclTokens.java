package dev.eventchain.eclipse.ui.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/**
 * Tokens of Complete OCL or of template tags. Only comments span lines, so any line outside a
 * comment can be read alone.
 */
public final class OclTokens {

  /** Keywords of Complete OCL. */
  static final List<String> KEYWORDS =
      List.of(
          "and",
          "body",
          "context",
          "def",
          "derive",
          "else",
          "endif",
          "endpackage",
          "false",
          "if",
          "implies",
          "import",
          "in",
          "include",
          "init",
          "inv",
          "invalid",
          "let",
          "library",
          "not",
          "null",
          "or",
          "package",
          "post",
          "pre",
          "self",
          "static",
          "then",
          "true",
          "xor");

  /** Predefined types of OCL. */
  static final List<String> TYPES =
      List.of(
          "Bag",
          "Boolean",
          "Collection",
          "Integer",
          "OclAny",
          "OclInvalid",
          "OclVoid",
          "OrderedSet",
          "Real",
          "Sequence",
          "Set",
          "String",
          "Tuple",
          "UnlimitedNatural");

  private static final Set<String> WORDS = Set.copyOf(KEYWORDS);

  private final String text;
  private final int limit;
  private final Set<String> types;
  private final boolean tags;
  private final List<Token> tokens = new ArrayList<>();

  private OclTokens(String text, int limit, Set<String> types, boolean tags) {
    this.text = text;
    this.limit = limit;
    this.types = types;
    this.tags = tags;
  }

  /**
   * Returns the tokens of constraints.
   *
   * @param types the names of classes, besides those of OCL
   * @return tokens that cover the whole text, in order
   */
  public static List<Token> of(String text, Set<String> types) {
    return new OclTokens(text, text.length(), types, false).read(0);
  }

  /** Returns the tokens of a part of a template tag. */
  static List<Token> ofTag(String text, int start, int end, Set<String> types) {
    return new OclTokens(text, end, types, true).read(start);
  }

  private List<Token> read(int start) {
    int position = start;
    while (position < limit) {
      int end = end(position);
      add(kind(position, end), position, end);
      position = end;
    }
    return tokens;
  }

  private void add(TokenKind kind, int start, int end) {
    int last = tokens.size() - 1;
    boolean more = last >= 0 && kind == TokenKind.CODE && tokens.get(last).kind() == kind;
    if (more) {
      tokens.set(last, new Token(kind, tokens.get(last).start(), end));
    } else {
      tokens.add(new Token(kind, start, end));
    }
  }

  private int end(int start) {
    char c = text.charAt(start);
    if (tags && c == '[') {
      return TemplateTokens.endOfOpening(text, start, limit);
    } else if (tags && text.startsWith("/]", start) && start + 2 <= limit) {
      return start + 2;
    } else if (!tags && text.startsWith("--", start)) {
      return endOfLine(text, start, limit);
    } else if (!tags && text.startsWith("/*", start)) {
      int end = text.indexOf("*/", start + 2);
      return end < 0 ? limit : Math.min(end + 2, limit);
    } else if (c == '\'' || c == '"' && !tags) {
      return endOfString(text, start, limit);
    } else if (Character.isDigit(c)) {
      return endOfNumber(start);
    }
    int end = start + 1;
    while (Character.isJavaIdentifierPart(c)
        && end < limit
        && Character.isJavaIdentifierPart(text.charAt(end))) {
      end++;
    }
    return end;
  }

  private TokenKind kind(int start, int end) {
    char c = text.charAt(start);
    if (tags && (c == '[' || c == ']' || text.startsWith("/]", start))) {
      return TokenKind.TAG;
    } else if (!tags && (text.startsWith("--", start) || text.startsWith("/*", start))) {
      return TokenKind.COMMENT;
    } else if (c == '\'' || c == '"' && !tags) {
      return TokenKind.STRING;
    } else if (Character.isDigit(c)) {
      return TokenKind.NUMBER;
    }
    String word = text.substring(start, end);
    if (WORDS.contains(word) || tags && TemplateTokens.MODIFIERS.contains(word)) {
      return isFeature(start) ? TokenKind.CODE : TokenKind.KEYWORD;
    }
    return types.contains(word) || TYPES.contains(word) ? TokenKind.TYPE : TokenKind.CODE;
  }

  /** Returns whether a word follows a dot or an arrow, so that it is no keyword. */
  private boolean isFeature(int start) {
    int before = start - 1;
    return before >= 0 && (text.charAt(before) == '.' || text.startsWith("->", before - 1));
  }

  private int endOfNumber(int start) {
    int end = digits(start);
    if (end + 1 < limit && text.charAt(end) == '.' && Character.isDigit(text.charAt(end + 1))) {
      end = digits(end + 1);
    }
    if (end < limit && "eE".indexOf(text.charAt(end)) >= 0) {
      int exponent = end + 1;
      exponent += exponent < limit && "+-".indexOf(text.charAt(exponent)) >= 0 ? 1 : 0;
      end = exponent < limit && Character.isDigit(text.charAt(exponent)) ? digits(exponent) : end;
    }
    return end;
  }

  private int digits(int start) {
    int end = start;
    while (end < limit && Character.isDigit(text.charAt(end))) {
      end++;
    }
    return end;
  }

  static int endOfLine(String text, int start, int limit) {
    int end = start;
    while (end < limit && text.charAt(end) != '\n' && text.charAt(end) != '\r') {
      end++;
    }
    return end;
  }

  /** Returns the end of a string, or of its line if it has none. */
  static int endOfString(String text, int start, int limit) {
    char quote = text.charAt(start);
    int line = endOfLine(text, start, limit);
    for (int i = start + 1; i < line; i++) {
      if (text.charAt(i) == '\\') {
        i++;
      } else if (text.charAt(i) == quote) {
        return i + 1;
      }
    }
    return line;
  }
}
