package dev.eventchain.m2t.syntax;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;

/** An offset in a template file; its line is computed on demand. */
public record Place(SourceText source, int offset) {
  public SourceLocation location() {
    return source.at(offset);
  }
}
