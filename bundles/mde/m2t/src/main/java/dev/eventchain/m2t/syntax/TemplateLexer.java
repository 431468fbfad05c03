package dev.eventchain.m2t.syntax;

import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.m2t.syntax.Token.Kind;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/**
 * Lexer that splits a template file into text and tags. It recognises tags, but not their nesting.
 */
public final class TemplateLexer {
  private static final List<String> BLOCKS =
      List.of("template", "for", "if", "let", "file", "protected", "trace", "macro");
  private static final List<String> MIDDLES = List.of("elseif", "else", "elselet");
  private static final List<String> DECLARATIONS = List.of("module", "import", "query");

  /** All keywords, in the order of precedence for suggestions. */
  private static final List<String> KEYWORDS =
      Stream.of(BLOCKS, MIDDLES, DECLARATIONS).flatMap(List::stream).toList();

  private static final String COMMENT = "comment";
  private static final String COMMENT_BEGIN = "[comment]";
  private static final String COMMENT_END = "[/comment]";

  /** Keywords that can also start an OCL expression. */
  private static final Set<String> EXPRESSION_KEYWORDS = Set.of("if", "let");

  private static final String BRACKET_HINT = "A bracket that is meant as text is written ['['/].";

  private final String text;
  private final Problems problems;
  private final List<Token> tokens = new ArrayList<>();
  private final Map<String, Integer> found = new HashMap<>();

  private TemplateLexer(Problems problems) {
    this.text = problems.source().text();
    this.problems = problems;
  }

  /** Returns the tokens of a template, which cover its whole text; reports tags without an end. */
  public static List<Token> tokens(Problems problems) {
    return new TemplateLexer(problems).tokens();
  }

  /** Returns the words that begin a tag, in alphabetical order. */
  public static List<String> keywords() {
    return Stream.concat(KEYWORDS.stream(), Stream.of(COMMENT)).sorted().toList();
  }

  private List<Token> tokens() {
    int position = 0;
    while (position < text.length() && !problems.areTooMany()) {
      int bracket = text.indexOf('[', position);
      int textEnd = bracket < 0 ? text.length() : bracket;
      if (textEnd > position) {
        tokens.add(Token.text(position, textEnd));
      }
      position = textEnd;
      if (bracket >= 0) {
        Token tag = tag(bracket);
        tokens.add(tag);
        position = tag.end();
        if (isEmptyTemplate(tag)) {
          tokens.add(new Token(Kind.CLOSE, "template", position, position, position, position));
        }
      }
    }
    return List.copyOf(tokens);
  }

  /** Returns whether a tag is a whole template: {@code [template public t(c : C)/]}. */
  private boolean isEmptyTemplate(Token tag) {
    return tag.kind() == Kind.OPEN
        && tag.keyword().equals("template")
        && text.charAt(tag.contentEnd()) == '/';
  }

  private Token tag(int start) {
    if (text.startsWith("[**", start)) {
      return commentUntil(start, start + 3, "/]");
    }
    if (text.startsWith("[--", start)) {
      return lineComment(start);
    }
    int nameStart = skipSpace(start + 1);
    if (nameStart < text.length() && text.charAt(nameStart) == '/') {
      return closing(start, nameStart + 1);
    }
    int nameEnd = endOfName(nameStart);
    String keyword = keywordAt(nameStart, nameEnd);
    if (keyword.equals(COMMENT)) {
      return comment(start, nameEnd);
    }
    return keyword.isEmpty() ? expression(start, start + 1) : keywordTag(start, keyword, nameEnd);
  }

  /** Returns the keyword of a tag; empty if the name starts an expression. */
  private String keywordAt(int nameStart, int nameEnd) {
    String name = text.substring(nameStart, nameEnd);
    boolean known =
        name.equals(COMMENT)
            || BLOCKS.contains(name)
            || MIDDLES.contains(name)
            || DECLARATIONS.contains(name);
    if (!known || nameEnd >= text.length()) {
      return "";
    }
    char next = text.charAt(nameEnd);
    boolean separate = Character.isWhitespace(next) || next == '(' || next == ']';
    boolean endsComment = name.equals(COMMENT) && (next == '/' || next == ':');
    return separate || endsComment ? name : "";
  }

  private Token keywordTag(int start, String keyword, int contentStart) {
    TagEnd end = TagEnd.find(text, contentStart);
    if (!end.found()) {
      return unclosed(start, end);
    }
    int slashAt = slash(contentStart, end);
    boolean slash = slashAt >= 0;
    int contentEnd = slash ? slashAt : end.offset();
    if (slash && EXPRESSION_KEYWORDS.contains(keyword)) {
      return expression(start, start + 1);
    }
    if (DECLARATIONS.contains(keyword)) {
      return token(Kind.DECLARATION, keyword, start, end, contentStart, contentEnd);
    }
    if (slash && !keyword.equals("template")) {
      problems.syntax(
          start,
          "A '" + keyword + "' block starts with a tag that ends with ']', not with '/]'.",
          "Write [" + keyword + " ...] and close the block with [/" + keyword + "].");
    }
    Kind kind = MIDDLES.contains(keyword) ? Kind.MIDDLE : Kind.OPEN;
    return token(kind, keyword, start, end, contentStart, contentEnd);
  }

  private static Token token(
      Kind kind, String keyword, int start, TagEnd end, int contentStart, int contentEnd) {
    return new Token(kind, keyword, start, end.offset() + 1, contentStart, contentEnd);
  }

  private Token expression(int start, int contentStart) {
    TagEnd end = TagEnd.find(text, contentStart);
    if (!end.found()) {
      return unclosed(start, end);
    }
    int slash = slash(contentStart, end);
    if (slash < 0) {
      Optional<Token> meant = misspelt(start, contentStart, end);
      if (meant.isPresent()) {
        return meant.get();
      }
      problems.syntax(start, "An expression ends with '/]', this one with ']'.", BRACKET_HINT);
      return broken(start, end.offset() + 1);
    }
    return token(Kind.EXPRESSION, "", start, end, contentStart, slash);
  }

  /**
   * Returns the offset of the slash before the end of a tag, with optional white space between;
   * otherwise -1.
   */
  private int slash(int contentStart, TagEnd end) {
    int last = end.offset() - 1;
    while (last > contentStart && Character.isWhitespace(text.charAt(last))) {
      last--;
    }
    return last >= contentStart && text.charAt(last) == '/' ? last : -1;
  }

  /** Returns the tag of a block with a misspelt keyword, which is reported. */
  private Optional<Token> misspelt(int start, int contentStart, TagEnd end) {
    int nameStart = skipSpace(contentStart);
    int nameEnd = endOfName(nameStart);
    String name = text.substring(nameStart, nameEnd);
    String meant = name.length() < 2 ? "" : NearestName.of(name, KEYWORDS).orElse("");
    if (meant.isEmpty() || " ([{]".indexOf(text.charAt(nameEnd)) < 0) {
      return Optional.empty();
    }
    problems.syntax(
        start,
        "There is no block '" + name + "'.",
        "Did you mean `" + meant + "`? " + BRACKET_HINT);
    Kind kind =
        DECLARATIONS.contains(meant)
            ? Kind.DECLARATION
            : MIDDLES.contains(meant) ? Kind.MIDDLE : Kind.OPEN;
    return Optional.of(token(kind, meant, start, end, nameEnd, end.offset()));
  }

  private Token closing(int start, int nameStart) {
    int nameEnd = endOfName(nameStart);
    int end = skipSpace(nameEnd);
    String name = text.substring(nameStart, nameEnd);
    if (end < text.length() && text.charAt(end) == ']' && BLOCKS.contains(name)) {
      return new Token(Kind.CLOSE, name, start, end + 1, nameEnd, end);
    }
    boolean tagged = end < text.length() && text.charAt(end) == ']';
    String meant = tagged ? NearestName.of(name, BLOCKS).orElse("") : "";
    String message =
        name.isEmpty() || BLOCKS.contains(name)
            ? "This closing tag is incomplete."
            : "There is no block '" + name + "' to close.";
    if (!meant.isEmpty()) {
      problems.syntax(start, message, "Did you mean [/" + meant + "]?");
      return new Token(Kind.CLOSE, meant, start, end + 1, nameEnd, end);
    }
    boolean comment = name.equals(COMMENT);
    problems.syntax(
        start,
        comment ? "There is no comment to close here." : message,
        comment
            ? "A comment that ends with '/]' is closed already; write [comment] to close it here."
            : BLOCKS.contains(name)
                ? "A block is closed by its name alone: [/" + name + "]."
                : "A block is closed by its name, such as [/for] or [/template].");
    return broken(start, tagged ? end + 1 : nameEnd);
  }

  /** Reads a comment in one tag, or up to {@code [/comment]}. */
  private Token comment(int start, int nameEnd) {
    int slashEnd = next("/]", nameEnd);
    int plainEnd = next("]", nameEnd);
    boolean empty = plainEnd >= 0 && text.substring(nameEnd, plainEnd).isBlank();
    int blockEnd = empty ? blockEnd(nameEnd) : next(COMMENT_END, nameEnd);
    int nextComment = next("[comment", nameEnd);
    boolean closed = blockEnd > plainEnd && (nextComment < 0 || blockEnd < nextComment);
    boolean bracketed = plainEnd >= 0 && text.substring(nameEnd, plainEnd).indexOf('[') >= 0;
    boolean open = plainEnd >= 0 && (slashEnd < 0 || plainEnd < slashEnd);
    if (open && blockEnd > plainEnd && (empty || slashEnd < 0 || (closed && !bracketed))) {
      int end = blockEnd + COMMENT_END.length();
      return new Token(Kind.COMMENT, COMMENT, start, end, plainEnd + 1, blockEnd);
    }
    if (empty) {
      problems.syntax(start, "This comment is not closed.", "Close it with [/comment].");
      return broken(start, plainEnd + 1);
    }
    return commentUntil(start, nameEnd, "/]");
  }

  /**
   * Returns the offset of the tag that closes a comment, in which others may be nested; the next
   * such tag if it closes none of them, and -1 without one.
   */
  private int blockEnd(int from) {
    int first = next(COMMENT_END, from);
    int end = first;
    int inner = next(COMMENT_BEGIN, from);
    for (int open = 1; end >= 0; end = text.indexOf(COMMENT_END, end + 1)) {
      while (inner >= 0 && inner < end) {
        open++;
        inner = text.indexOf(COMMENT_BEGIN, inner + 1);
      }
      if (--open == 0) {
        return end;
      }
    }
    return first;
  }

  private Token lineComment(int start) {
    int end = next("--]", start + 3);
    int slashed = next("/]", start + 3);
    boolean plain = end >= 0 && (slashed < 0 || end < slashed);
    return commentUntil(start, start + 3, plain ? "--]" : "/]");
  }

  private Token commentUntil(int start, int contentStart, String closer) {
    int end = next(closer, contentStart);
    if (end < 0) {
      problems.syntax(start, "This comment is not closed.", "Close it with '" + closer + "'.");
      return broken(start, contentStart);
    }
    return new Token(Kind.COMMENT, COMMENT, start, end + closer.length(), contentStart, end);
  }

  /** Returns the next offset of a text; each part of the file is searched once for each text. */
  private int next(String wanted, int from) {
    Integer known = found.get(wanted);
    if (known == null || (known >= 0 && known < from)) {
      known = text.indexOf(wanted, from);
      found.put(wanted, known);
    }
    return known;
  }

  private Token unclosed(int start, TagEnd end) {
    String message =
        end.openQuote() >= 0
            ? "The text that starts here has no closing quote on its line."
            : "This tag is not closed.";
    problems.syntax(end.openQuote() >= 0 ? end.openQuote() : start, message, BRACKET_HINT);
    return broken(start, Math.max(end.offset(), start + 1));
  }

  private static Token broken(int start, int end) {
    return new Token(Kind.BROKEN, "", start, end, start, end);
  }

  private int skipSpace(int from) {
    int position = from;
    while (position < text.length() && Character.isWhitespace(text.charAt(position))) {
      position++;
    }
    return position;
  }

  private int endOfName(int from) {
    int position = from;
    while (position < text.length() && Character.isJavaIdentifierPart(text.charAt(position))) {
      position++;
    }
    return position;
  }
}
