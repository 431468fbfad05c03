package dev.eventchain.ocl.evaluation;

import dev.eventchain.diagnostics.CommonTrait;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;

/**
 * OCL's {@code invalid}, which is not {@code null}, with its reason.
 *
 * @param reason the innermost operation that failed and the value it failed on
 * @param location the place of that operation in the source of the expression, or in the source of
 *     a definition it calls
 * @param kind the kind of failure, by which reporters choose their hints
 * @param cause its exception, such as one of an {@code OperationLibrary}; {@code null} if none
 */
public record Invalid(String reason, SourceLocation location, Kind kind, RuntimeException cause) {

  /** Rule of the findings about an evaluation that was stopped, see {@link #limit}. */
  public static final Rule ABANDONED = Rule.error("ocl.limit", CommonTrait.UNSUPPRESSIBLE);

  /** Kinds of failures. */
  public enum Kind {
    /** An operation on null. */
    NULL,
    /** An operation on an empty collection that needs an element. */
    EMPTY,
    /** Recursion of a definition that is endless or too deep. */
    RECURSION,
    /** Too much time, or a value that is too large. */
    COST,
    /** An operation without result for its source and arguments. */
    OTHER
  }

  /** Creates one without exception. */
  public Invalid(String reason, SourceLocation location, Kind kind) {
    this(reason, location, kind, null);
  }

  /** Returns whether the evaluation was stopped, so that the value is unknown. */
  public boolean limit() {
    return kind == Kind.RECURSION || kind == Kind.COST;
  }
}
