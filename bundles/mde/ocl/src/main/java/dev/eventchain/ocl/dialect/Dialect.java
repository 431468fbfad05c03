package dev.eventchain.ocl.dialect;

import java.util.List;
import java.util.Optional;
import org.eclipse.emf.ecore.EClassifier;

/**
 * Where an expression language goes beyond OCL: its own operations, what its types let pass, and
 * what may be done in place of something slower. Must be thread-safe.
 */
public interface Dialect {

  /** OCL with its standard library and nothing else. */
  Dialect STANDARD = new Dialect() {};

  /** Operations that are tried before those of the standard library, in this order. */
  default List<OperationLibrary> libraries() {
    return List.of();
  }

  /**
   * Whether the operations of collections take arguments of any type, as {@code including} a Book
   * into a Set(Novel), where standard OCL asks for the type of the elements. The elements of the
   * result have the type that the operation would give if it took them.
   */
  default boolean takesAnyElement() {
    return false;
  }

  /**
   * A type whose operations are tried where the static type of a source has none of a name; a value
   * that turns out to be of another type makes the call invalid.
   */
  default Optional<EClassifier> assumed(EClassifier type) {
    return Optional.empty();
  }

  /**
   * Whether a simple name that no metamodel has means the type of everything where a variable, a
   * parameter or a result is declared. It never does in an expression.
   */
  default boolean meansAnyType(String name) {
    return false;
  }

  /**
   * What can be called in place of an operation of a library of which only one end is asked for:
   * {@code x.f()->first()}. It gives a collection that has the same first element, or the same last
   * one, and is empty if the other is.
   *
   * @return empty if that is not easier than the operation itself
   */
  default Optional<OperationLibrary.Implementation> endOf(
      OperationLibrary.Implementation operation, boolean first) {
    return Optional.empty();
  }
}
