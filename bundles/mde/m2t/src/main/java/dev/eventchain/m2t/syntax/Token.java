package dev.eventchain.m2t.syntax;

import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.diagnostics.SourceText;

/**
 * A piece of a template file: text between tags, or a tag.
 *
 * @param keyword the keyword of the tag: {@code for} for {@code [for (...)]} and {@code [/for]}
 * @param start the offset of the first character
 * @param end the offset after the last character
 * @param contentStart the offset where a tag's content starts, after its keyword
 * @param contentEnd the offset where it ends, before {@code ]} or {@code /]}
 */
public record Token(
    Kind kind, String keyword, int start, int end, int contentStart, int contentEnd) {
  /** Kind of a token. */
  public enum Kind {
    TEXT,
    EXPRESSION,
    COMMENT,
    /** {@code [module ...]}, {@code [import ...]}, {@code [query ... /]}. */
    DECLARATION,
    /** The first tag of a block. */
    OPEN,
    /** {@code [else]} and its like. */
    MIDDLE,
    /** The last tag of a block. */
    CLOSE,
    /** An invalid tag that was reported. */
    BROKEN
  }

  static Token text(int start, int end) {
    return new Token(Kind.TEXT, "", start, end, start, end);
  }

  /** Returns the content of a tag after its keyword. */
  SourceRange content(SourceText source) {
    return source.range(contentStart, contentEnd);
  }
}
