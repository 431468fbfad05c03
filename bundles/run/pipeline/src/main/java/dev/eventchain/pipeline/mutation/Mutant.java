package dev.eventchain.pipeline.mutation;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.sandbox.ComponentMutant;
import java.nio.file.Path;

/**
 * A mutant of a component of the chain.
 *
 * @param component the component's name
 * @param file the component's file
 * @param source its text
 * @param defect the defect
 * @param hosted whether the component is a node that is hosted as it is, which has no tests of its
 *     own
 */
record Mutant(
    String component, Path file, SourceText source, ComponentMutant defect, boolean hosted) {

  String id() {
    return defect.id();
  }

  /** Returns the text of the component with the defect. */
  String text() {
    return defect.in(source.text());
  }

  SourceLocation location() {
    return source.at(defect.line(), defect.column()).withElement(component);
  }
}
