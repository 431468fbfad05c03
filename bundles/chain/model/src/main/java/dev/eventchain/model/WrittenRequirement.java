package dev.eventchain.model;

import dev.eventchain.diagnostics.SourceLocation;

/**
 * A requirement or a design rule as people wrote it, independent of the chain that satisfies it.
 *
 * @param id the id under which people know it
 * @param text its words, on one line
 * @param location where it is written
 */
public record WrittenRequirement(String id, String text, SourceLocation location) {}
