package dev.eventchain.roads.xml;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;

/**
 * The place of an element without the element, for what can be checked only when all is read.
 *
 * @param offset of the element's first character
 * @param path of the element
 */
public record Place(SourceText source, int offset, String path) {

  /** Returns the place with its line. */
  public SourceLocation location() {
    return source.at(offset).withElement(path);
  }
}
