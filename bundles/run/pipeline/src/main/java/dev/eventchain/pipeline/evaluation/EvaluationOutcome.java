package dev.eventchain.pipeline.evaluation;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException.Reason;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * How an evaluation ended.
 *
 * @param table what it came to, for people
 * @param diagnostics what keeps it from being whole, or from being an evaluation
 * @param failure why it is not whole, if it is not
 * @param files what was written for people
 */
public record EvaluationOutcome(
    String table, List<Diagnostic> diagnostics, Optional<Reason> failure, List<Path> files) {}
