package dev.eventchain.eclipse.ui.text;

import dev.eventchain.m2t.TemplateParts;
import dev.eventchain.ocl.text.Keywords;
import dev.eventchain.ocl.text.Lexer;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/**
 * Tokens of Complete OCL or of template tags. Only comments span lines, so any line outside a
 * comment can be read alone.
 */
public final class OclTokens {

  private static final Set<String> KEYWORDS = Set.copyOf(Keywords.ALL);
  private static final Set<String> MODIFIERS = Set.copyOf(TemplateParts.MODIFIERS);

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
    } else if (tags && "\"-/".indexOf(c) >= 0) {
      return start + 1; // tags have no comments, and only one kind of quotes
    }
    return Character.isDigit(c)
        ? Lexer.endOfNumber(text, start, limit)
        : Lexer.end(text, start, limit);
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
    if (KEYWORDS.contains(word) || tags && MODIFIERS.contains(word)) {
      return isFeature(start) ? TokenKind.CODE : TokenKind.KEYWORD;
    }
    return types.contains(word) || Keywords.TYPES.contains(word) ? TokenKind.TYPE : TokenKind.CODE;
  }

  /** Returns whether a word follows a dot or an arrow, so that it is no keyword. */
  private boolean isFeature(int start) {
    int before = start - 1;
    return before >= 0 && (text.charAt(before) == '.' || text.startsWith("->", before - 1));
  }
}
