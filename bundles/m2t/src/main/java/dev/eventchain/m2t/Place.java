package dev.eventchain.m2t;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;

/** An offset in a template file; its line is only counted when somebody asks. */
record Place(SourceText source, int offset) {
  SourceLocation location() {
    return source.at(offset);
  }
}
