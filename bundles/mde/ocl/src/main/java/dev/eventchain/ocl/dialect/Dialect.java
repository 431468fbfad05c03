package dev.eventchain.ocl.dialect;

import java.util.List;
import java.util.Optional;
import org.eclipse.emf.ecore.EClassifier;

/**
 * Extensions of an expression language beyond OCL: its own operations, looser typing, and faster
 * substitutes of operations. Must be thread-safe.
 */
public interface Dialect {

  /** OCL with its standard library and nothing else. */
  Dialect STANDARD = new Dialect() {};

  /** Returns the libraries that are tried in this order before the standard library. */
  default List<OperationLibrary> libraries() {
    return List.of();
  }

  /**
   * Returns whether operations of collections take arguments of any type, as {@code including} a
   * Book into a Set(Novel), where standard OCL requires the type of the elements. The result has
   * the element type that such an operation would give.
   */
  default boolean takesAnyElement() {
    return false;
  }

  /**
   * Returns a type whose operations are tried if the static type of a source has none of that name;
   * values of other types make the call invalid.
   */
  default Optional<EClassifier> assumed(EClassifier type) {
    return Optional.empty();
  }

  /**
   * Returns whether a simple name that is in no metamodel means the top type in declarations of
   * variables, parameters and results; never in an expression.
   */
  default boolean meansAnyType(String name) {
    return false;
  }

  /**
   * Returns whether a name of types in several packages means the first one: an outer package comes
   * before its nested ones, and a metamodel before later ones. Otherwise, such a name is an error.
   */
  default boolean takesFirstType() {
    return false;
  }

  /**
   * Returns a substitute for a library operation of whose result only one end is used: {@code
   * x.f()->first()}. Its result has the same first or last element, and is empty if the original
   * is.
   *
   * @return empty if there is none that is cheaper
   */
  default Optional<OperationLibrary.Implementation> endOf(
      OperationLibrary.Implementation operation, boolean first) {
    return Optional.empty();
  }
}
