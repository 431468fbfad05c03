package dev.eventchain.ocl.evaluation;

import dev.eventchain.diagnostics.SourceLocation;

/**
 * The value of an expression that has none: OCL's {@code invalid}, which is not {@code null}.
 *
 * @param reason why: the innermost operation that failed and the value it failed on
 * @param location the place of that operation in the source of the expression, or in the source of
 *     a definition it calls
 * @param kind what sort of failure it is, by which the one who reports it chooses his advice
 * @param cause the exception that it comes from, such as one of an {@code OperationLibrary}; {@code
 *     null} if there was none
 */
public record Invalid(String reason, SourceLocation location, Kind kind, RuntimeException cause) {

  /** Sorts of failures. */
  public enum Kind {
    /** Something is asked of null. */
    NULL,
    /** Something is asked of a collection without elements that only its elements can answer. */
    EMPTY,
    /** A definition calls itself without end, or too deeply. */
    RECURSION,
    /** It takes too long or makes too much. */
    COST,
    /** The operation has no result for its source and its arguments. */
    OTHER
  }

  /** One that no exception led to. */
  public Invalid(String reason, SourceLocation location, Kind kind) {
    this(reason, location, kind, null);
  }

  /** Whether the evaluation was stopped, so that nothing is known of the value. */
  public boolean limit() {
    return kind == Kind.RECURSION || kind == Kind.COST;
  }
}
