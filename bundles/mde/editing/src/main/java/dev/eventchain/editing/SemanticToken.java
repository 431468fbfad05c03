package dev.eventchain.editing;

/**
 * A word of a text and what it means; on one line.
 *
 * @param line the line, from 0
 * @param column the first column in UTF-16 units
 * @param length the length in UTF-16 units, at least 1
 * @param declaration true where what it names is declared
 */
public record SemanticToken(int line, int column, int length, Kind kind, boolean declaration) {

  /** Kind of thing that a word means. */
  public enum Kind {
    KEYWORD,
    COMMENT,
    STRING,
    NUMBER,
    OPERATOR,
    TYPE,
    ENUMERATION_LITERAL,
    NAMESPACE,
    PROPERTY,
    OPERATION,
    /** A template, a query or a rule. */
    FUNCTION,
    VARIABLE,
    PARAMETER,
    /** An annotation in a comment, such as {@code @main}. */
    ANNOTATION
  }
}
