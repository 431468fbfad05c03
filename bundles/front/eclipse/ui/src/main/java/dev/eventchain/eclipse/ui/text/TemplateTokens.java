package dev.eventchain.eclipse.ui.text;

import dev.eventchain.m2t.TemplateParts;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/** The tokens of a template of MOFM2T: text, comments and tags, as the generator delimits them. */
public final class TemplateTokens {

  private static final Set<String> KEYWORDS = Set.copyOf(TemplateParts.KEYWORDS);

  private TemplateTokens() {}

  /**
   * Returns the tokens of a template.
   *
   * @param types the names of classes, besides those of OCL
   * @return tokens that cover the whole text, in order
   */
  public static List<Token> of(String text, Set<String> types) {
    List<Token> tokens = new ArrayList<>();
    for (Token part : parts(text)) {
      if (part.kind() == TokenKind.TAG) {
        tokens.addAll(OclTokens.ofTag(text, part.start(), part.end(), types));
      } else {
        tokens.add(part);
      }
    }
    return tokens;
  }

  /**
   * Divides a template into {@code TEXT}, {@code TAG} and {@code COMMENT}.
   *
   * @return parts that cover the whole text, in order
   */
  public static List<Token> parts(String text) {
    return TemplateParts.of(text).stream()
        .map(part -> new Token(kind(part.kind()), part.start(), part.end()))
        .toList();
  }

  private static TokenKind kind(TemplateParts.Kind kind) {
    return switch (kind) {
      case TEXT -> TokenKind.TEXT;
      case TAG -> TokenKind.TAG;
      case COMMENT -> TokenKind.COMMENT;
    };
  }

  /**
   * Returns the offset after the bracket of a tag and its keyword: {@code [for}, {@code [/for},
   * {@code [}.
   */
  static int endOfOpening(String text, int bracket, int limit) {
    int start = skipSpace(text, bracket + 1, limit);
    boolean closing = start < limit && text.charAt(start) == '/';
    start = closing ? start + 1 : start;
    int end = start;
    while (end < limit && Character.isJavaIdentifierPart(text.charAt(end))) {
      end++;
    }
    boolean keyword = KEYWORDS.contains(text.substring(start, end));
    return keyword || closing ? end : bracket + 1;
  }

  private static int skipSpace(String text, int from, int limit) {
    int position = from;
    while (position < limit && Character.isWhitespace(text.charAt(position))) {
      position++;
    }
    return position;
  }
}
