package dev.eventchain.editing;

/** The kinds of what a symbol, a completion or a call is about. */
public enum ElementKind {
  FILE,
  MODULE,
  PACKAGE,
  CLASS,
  DATA_TYPE,
  ENUMERATION,
  ENUMERATION_LITERAL,
  /** A standard type, such as String or Sequence. */
  STANDARD_TYPE,
  ATTRIBUTE,
  REFERENCE,
  OPERATION,
  /** An operation that works on a collection with an expression, such as {@code select}. */
  ITERATOR,
  TEMPLATE,
  QUERY,
  INVARIANT,
  /** An operation or a property that a rule document adds to a class. */
  DEFINITION,
  VARIABLE,
  PARAMETER,
  /** The context of rules. */
  CONTEXT,
  /** A block of a template, such as {@code [for]}. */
  BLOCK,
  ANNOTATION,
  KEYWORD,
  SNIPPET
}
