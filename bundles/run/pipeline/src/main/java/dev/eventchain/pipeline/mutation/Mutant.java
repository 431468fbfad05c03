package dev.eventchain.pipeline.mutation;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.sandbox.ComponentMutant;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * A mutant of a component of the chain, or of a module that components import.
 *
 * @param component the component's name, or the module's path in the project
 * @param file the file of the component or module
 * @param source its text
 * @param defect the defect
 * @param kind what has the defect
 * @param users the names of the components and nodes that run it, in the order of the chain
 * @param tested the component whose tests run it, or could; empty if there is none
 */
record Mutant(
    String component,
    Path file,
    SourceText source,
    ComponentMutant defect,
    Kind kind,
    List<String> users,
    Optional<String> tested) {

  /** Part of a project that has mutants. */
  enum Kind {
    /** A class with {@code execute}. */
    COMPONENT,
    /** A node that is hosted as it is, which has no tests of its own. */
    NODE,
    /** A module that some of these import. */
    MODULE
  }

  /** Copies the list. */
  Mutant {
    users = List.copyOf(users);
  }

  /** Returns the same mutant with one more node that runs it. */
  Mutant alsoIn(String node) {
    List<String> all = new ArrayList<>(users);
    all.add(node);
    return new Mutant(component, file, source, defect, kind, all, tested);
  }

  String id() {
    return defect.id();
  }

  /** Returns the text of the file with the defect. */
  String text() {
    return defect.in(source.text());
  }

  SourceLocation location() {
    SourceLocation place = source.at(defect.line(), defect.column());
    return kind == Kind.MODULE ? place : place.withElement(component);
  }
}
