package dev.eventchain.m2t.editing;

import java.nio.file.Path;

/** A template or a query, by its number among those of its file. */
record CallableKey(Path file, boolean template, int number) {}
