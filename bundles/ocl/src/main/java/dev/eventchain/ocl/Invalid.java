package dev.eventchain.ocl;

import dev.eventchain.diagnostics.SourceLocation;

/**
 * The value of an expression that has none: OCL's {@code invalid}, which is not {@code null}.
 *
 * @param reason why: the innermost operation that failed and the value it failed on
 * @param location the place of that operation in the source of the expression, or in the source of
 *     a definition it calls
 * @param limit whether the evaluation was stopped because it recursed too deeply or took too long
 * @param cause the exception that it comes from, such as one of an {@link OperationLibrary}; {@code
 *     null} if there was none
 */
public record Invalid(
    String reason, SourceLocation location, boolean limit, RuntimeException cause) {

  /** One that no exception led to. */
  public Invalid(String reason, SourceLocation location, boolean limit) {
    this(reason, location, limit, null);
  }
}
