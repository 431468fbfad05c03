package dev.eventchain.ocl.dialect;

import dev.eventchain.ocl.evaluation.Evaluation;
import dev.eventchain.ocl.evaluation.Invalid;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import org.eclipse.emf.ecore.EClassifier;

/**
 * Operations of an expression language besides those of OCL and of the metamodels. Calls are looked
 * up in libraries at parse time, before the standard operations, with the static types; so the
 * result type can depend on the argument types, as for {@code filter(T)}.
 *
 * <p>A type literal as argument has its own type; {@link TypeSystem#referredType(EClassifier)}
 * gives the type that it names, and at run time the argument is that {@link EClassifier} itself.
 */
@FunctionalInterface
public interface OperationLibrary {

  /**
   * Finds the operation of a call. The same arguments must always give the same result.
   *
   * @param types the types of the language of the expression
   * @param source the static type before the arrow or the dot; for a dot after a collection, the
   *     type of its elements. {@code null} for a call without source, {@code f(x)}, which is tried
   *     before the implicit source {@code self}
   * @param name the name of the operation, or an infix operator
   * @param argumentTypes the static types of the arguments
   * @return empty if the library has no such operation
   */
  Optional<Operation> lookup(
      TypeSystem types, EClassifier source, String name, List<EClassifier> argumentTypes);

  /**
   * Finds an operation that takes only some values of the static types. Used if neither a library
   * nor the standard nor the metamodel has one that takes them all; the operation must check its
   * arguments.
   */
  default Optional<Operation> lookupLoosely(
      TypeSystem types, EClassifier source, String name, List<EClassifier> argumentTypes) {
    return Optional.empty();
  }

  /** Returns the names of the operations, for hints about misspelt calls. */
  default Collection<String> names() {
    return List.of();
  }

  /**
   * Returns the operations for sources of a type, for editors.
   *
   * @param source as for {@link #lookup}
   */
  default List<Signature> signatures(TypeSystem types, EClassifier source) {
    return List.of();
  }

  /**
   * An operation as an editor shows it.
   *
   * @param parameters the parameters after the source, such as {@code index : Integer}
   * @param result the type of the result, as far as it does not depend on a call; may be empty
   * @param origin what kind of operation it is: {@code template}, {@code query}; empty for one of
   *     the library itself
   */
  record Signature(String name, List<String> parameters, String result, String origin) {}

  /**
   * An operation of a library.
   *
   * @param name its name
   * @param resultType the static type of the result of this call
   * @param implementation its implementation
   */
  record Operation(String name, EClassifier resultType, Implementation implementation) {}

  /** The implementation of an operation. Must be thread-safe. */
  @FunctionalInterface
  interface Implementation {

    /**
     * Computes the result. Not called for an invalid source or argument, which makes the result
     * invalid. An exception makes it invalid, too, with its message as the reason.
     *
     * @param source the source, which may be {@code null}; always {@code null} for a call without
     * @param arguments the arguments, each of which may be {@code null}
     * @param run the current evaluation; further expressions may be evaluated in it
     * @return a value of the result type, {@code null}, or an {@link Invalid}; any {@link
     *     java.util.Collection} for a collection type
     */
    Object call(Object source, List<Object> arguments, Evaluation run);

    /**
     * Returns whether the operation is pure: repeated calls have the same result and no effects.
     * Otherwise results are kept until the expression has been evaluated, to explain invalid
     * values.
     */
    default boolean isRepeatable() {
      return false;
    }

    /**
     * Returns whether the result contains only elements of the source, each at most as often; a
     * single value counts as a collection of one.
     */
    default boolean isSelection() {
      return false;
    }

    /** Returns whether results may have other types than the result type. */
    default boolean mayGiveOtherTypes() {
      return false;
    }

    /**
     * Returns whether collections keep the kind that they were made with. Otherwise they get the
     * kind of the result type.
     */
    default boolean keepsKinds() {
      return false;
    }
  }
}
