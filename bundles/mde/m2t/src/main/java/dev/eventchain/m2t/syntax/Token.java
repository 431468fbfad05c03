package dev.eventchain.m2t.syntax;

import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.diagnostics.SourceText;

/**
 * A piece of a template file: text between tags, or a tag.
 *
 * @param keyword what the tag is about: {@code for} for {@code [for (...)]} and {@code [/for]}
 * @param start offset of the first character
 * @param end offset after the last character
 * @param contentStart where a tag's content starts, after its keyword
 * @param contentEnd where it ends, before {@code ]} or {@code /]}
 */
record Token(Kind kind, String keyword, int start, int end, int contentStart, int contentEnd) {
  /** What a piece is. */
  enum Kind {
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
    /** A tag that was reported already. */
    BROKEN
  }

  static Token text(int start, int end) {
    return new Token(Kind.TEXT, "", start, end, start, end);
  }

  /** What is in a tag after its keyword. */
  SourceRange content(SourceText source) {
    return source.range(contentStart, contentEnd);
  }

  boolean isBlockTag() {
    return kind == Kind.OPEN || kind == Kind.MIDDLE || kind == Kind.CLOSE;
  }
}
