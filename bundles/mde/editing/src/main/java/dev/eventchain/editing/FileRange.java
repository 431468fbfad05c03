package dev.eventchain.editing;

import java.nio.file.Path;

/**
 * A range of a file's text.
 *
 * @param file the file, named as the {@link Workspace} names it
 * @param range the range in it
 */
public record FileRange(Path file, TextRange range) {}
