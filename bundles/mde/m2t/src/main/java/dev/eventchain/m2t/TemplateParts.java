package dev.eventchain.m2t;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.m2t.syntax.Problems;
import dev.eventchain.m2t.syntax.TemplateLexer;
import dev.eventchain.m2t.syntax.Token;
import dev.eventchain.m2t.syntax.Words;
import java.util.ArrayList;
import java.util.List;

/** The text of any template file, valid or not, as text, tags and comments; for editors. */
public final class TemplateParts {

  /** The words that begin a tag, in alphabetical order. */
  public static final List<String> KEYWORDS = TemplateLexer.keywords();

  /** The words inside the tags of blocks and declarations, in alphabetical order. */
  public static final List<String> MODIFIERS = Words.all();

  /** The kinds of parts. */
  public enum Kind {
    /** Text that is copied unchanged, and tags without an end. */
    TEXT,
    TAG,
    COMMENT
  }

  /**
   * A part of a text.
   *
   * @param start the offset of its first character
   * @param end the offset after its last character
   */
  public record Part(Kind kind, int start, int end) {}

  private TemplateParts() {}

  /** Returns the parts of a text, which cover it in order; no two texts follow each other. */
  public static List<Part> of(String text) {
    List<Part> parts = new ArrayList<>();
    for (Token token : TemplateLexer.tokens(Problems.ignored(SourceText.of("", text)))) {
      int last = parts.size() - 1;
      Kind kind = kind(token, text);
      if (kind == Kind.TEXT && last >= 0 && parts.get(last).kind() == kind) {
        parts.set(last, new Part(kind, parts.get(last).start(), token.end()));
      } else if (token.end() > token.start()) {
        parts.add(new Part(kind, token.start(), token.end()));
      }
    }
    return parts;
  }

  private static Kind kind(Token token, String text) {
    return switch (token.kind()) {
      case TEXT -> Kind.TEXT;
      case COMMENT -> Kind.COMMENT;
      case BROKEN -> text.charAt(token.end() - 1) == ']' ? Kind.TAG : Kind.TEXT;
      default -> Kind.TAG;
    };
  }
}
