package dev.eventchain.pipeline.evaluation;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException.Reason;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * The outcome of an evaluation.
 *
 * @param table the table of results, for people
 * @param diagnostics the findings that make it incomplete or no evaluation
 * @param failure the reason why it is incomplete, if it is
 * @param files the files written for people
 */
public record EvaluationOutcome(
    String table, List<Diagnostic> diagnostics, Optional<Reason> failure, List<Path> files) {}
