package dev.eventchain.editing;

import java.nio.file.Path;

/**
 * The replacement of a range of a file's text. The ranges of the edits of one file do not overlap,
 * and all are those of the text before any edit.
 */
public record FileEdit(Path file, TextRange range, String newText) {}
