package dev.eventchain.model;

import dev.eventchain.diagnostics.SourceLocation;

/**
 * A requirement or a design rule as written by users, independent of the chain that satisfies it.
 *
 * @param id the id
 * @param text the text, on one line
 * @param location the location of its text
 */
public record WrittenRequirement(String id, String text, SourceLocation location) {}
