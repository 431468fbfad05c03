package dev.eventchain.eclipse.ui.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/**
 * The tokens of a template of MOFM2T: text, comments and tags, as the generator delimits them. A
 * tag without an end is text, as in the generator.
 */
public final class TemplateTokens {

  /** Keywords at the beginning of a tag. */
  static final List<String> BLOCKS =
      List.of(
          "comment",
          "else",
          "elseif",
          "elselet",
          "file",
          "for",
          "if",
          "import",
          "let",
          "macro",
          "module",
          "protected",
          "query",
          "template",
          "trace");

  /** Keywords inside the tags of blocks and declarations. */
  static final List<String> MODIFIERS =
      List.of("after", "before", "extends", "overrides", "private", "public", "separator", "super");

  private static final Set<String> TAGS = Set.copyOf(BLOCKS);
  private static final String COMMENT_END = "[/comment]";

  private final String text;
  private final List<Token> parts = new ArrayList<>();

  private TemplateTokens(String text) {
    this.text = text;
  }

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
    return new TemplateTokens(text).read();
  }

  private List<Token> read() {
    int position = 0;
    int textStart = 0;
    while (position < text.length()) {
      int bracket = text.indexOf('[', position);
      if (bracket < 0) {
        break;
      }
      boolean comment = isComment(bracket);
      int end = comment ? endOfComment(bracket) : endOfTag(bracket);
      if (end < 0) {
        position = bracket + 1;
        continue;
      }
      add(TokenKind.TEXT, textStart, bracket);
      add(comment ? TokenKind.COMMENT : TokenKind.TAG, bracket, end);
      position = end;
      textStart = end;
    }
    add(TokenKind.TEXT, textStart, text.length());
    return parts;
  }

  private void add(TokenKind kind, int start, int end) {
    if (end > start) {
      parts.add(new Token(kind, start, end));
    }
  }

  private boolean isComment(int bracket) {
    if (text.startsWith("[**", bracket) || text.startsWith("[--", bracket)) {
      return true;
    }
    int start = skipSpace(text, bracket + 1, text.length());
    int end = start + "comment".length();
    return text.startsWith("comment", start)
        && end < text.length()
        && (Character.isWhitespace(text.charAt(end)) || "(]/".indexOf(text.charAt(end)) >= 0);
  }

  /** Returns the offset after a comment, or -1 if it does not end. */
  private int endOfComment(int bracket) {
    int slashed = after("/]", bracket + 1);
    if (text.startsWith("[**", bracket)) {
      return slashed;
    } else if (text.startsWith("[--", bracket)) {
      int dashed = after("--]", bracket + 3);
      return dashed >= 0 && (slashed < 0 || dashed < slashed) ? dashed : slashed;
    }
    int plain = after("]", bracket);
    int block = after(COMMENT_END, bracket);
    boolean isBlock = block > plain && (slashed < 0 || plain < slashed);
    boolean empty = plain >= 0 && text.substring(bracket, plain - 1).endsWith("comment");
    return isBlock && (empty || slashed < 0 || block < slashed) ? block : empty ? -1 : slashed;
  }

  private int after(String wanted, int from) {
    int found = text.indexOf(wanted, from);
    return found < 0 ? -1 : found + wanted.length();
  }

  /**
   * Returns the offset after a tag, or -1 if another one begins first or a string does not end on
   * its line.
   */
  private int endOfTag(int bracket) {
    int position = bracket + 1;
    while (position < text.length()) {
      char c = text.charAt(position);
      if (c == ']') {
        return position + 1;
      } else if (c == '[') {
        return -1;
      } else if (c == '\'') {
        int end = OclTokens.endOfString(text, position, text.length());
        if (end - 1 == position || text.charAt(end - 1) != '\'') {
          return -1;
        }
        position = end - 1;
      }
      position++;
    }
    return -1;
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
    boolean keyword = TAGS.contains(text.substring(start, end));
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
