package dev.eventchain.pipeline.mutation;

import dev.eventchain.pipeline.Outcome;

/**
 * The outcome of mutation testing.
 *
 * @param outcome the findings, with the exit code
 * @param table what was noticed of each component, as text; empty if no mutant was tried
 */
public record MutationOutcome(Outcome outcome, String table) {}
