package dev.eventchain.ocl.dialect;

import dev.eventchain.ocl.evaluation.Evaluation;
import dev.eventchain.ocl.evaluation.Invalid;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import org.eclipse.emf.ecore.EClassifier;

/**
 * Operations that an expression language has besides those of OCL and of the metamodels. A library
 * is asked at parse time for each call, before the standard operations, with the types at hand;
 * hence the type of a result can depend on the types of the arguments, as that of {@code
 * filter(T)}.
 *
 * <p>A type literal given as argument has its own type; {@link
 * TypeSystem#referredType(EClassifier)} gives the type that it names, and at run time the argument
 * is that {@link EClassifier} itself.
 */
@FunctionalInterface
public interface OperationLibrary {

  /**
   * Finds the operation that a call means. The same arguments must always give the same answer.
   *
   * @param types the types of the language of the expression
   * @param source the static type before the arrow or the dot; for a dot after a collection the
   *     type of its elements, for they are called one by one; {@code null} for a call with nothing
   *     before it, {@code f(x)}, which is tried before {@code self} is taken as the source
   * @param name the name of the operation; an infix operator is one, too
   * @param argumentTypes the static types of the arguments
   * @return empty if the library has no such operation
   */
  Optional<Operation> lookup(
      TypeSystem types, EClassifier source, String name, List<EClassifier> argumentTypes);

  /**
   * Finds the operation that a call means for some values of these types only. It is asked where
   * neither a library nor the standard nor the metamodel has an operation that takes them all; the
   * operation has to look at its arguments.
   */
  default Optional<Operation> lookupLoosely(
      TypeSystem types, EClassifier source, String name, List<EClassifier> argumentTypes) {
    return Optional.empty();
  }

  /** The names of the operations, to find the one that a misspelt call means. */
  default Collection<String> names() {
    return List.of();
  }

  /**
   * An operation of a library.
   *
   * @param name its name
   * @param resultType the static type of the result of this call
   * @param implementation what it does
   */
  record Operation(String name, EClassifier resultType, Implementation implementation) {}

  /** What an operation does. Must be thread-safe. */
  @FunctionalInterface
  interface Implementation {

    /**
     * Computes the result. An invalid source or argument never gets here: it makes the result
     * invalid. An exception makes the result invalid, too, with its message as the reason.
     *
     * @param source the source, which may be {@code null}; always {@code null} for a call without
     * @param arguments the arguments, each of which may be {@code null}
     * @param run the evaluation at work; further expressions may be evaluated in it
     * @return a value of the result type, {@code null}, or an {@link Invalid}; any {@link
     *     java.util.Collection} will do for a collection type
     */
    Object call(Object source, List<Object> arguments, Evaluation run);

    /**
     * Whether calling once more with the same source and arguments changes nothing and gives the
     * same; otherwise the answer of each call is kept until its expression has been evaluated, in
     * case it is asked why it has no value.
     */
    default boolean isRepeatable() {
      return false;
    }

    /**
     * Whether the result holds nothing but elements of the source, each at most as often as that
     * does; a single value counts as a collection of one.
     */
    default boolean isSelection() {
      return false;
    }

    /** Whether a result may turn out to be of any other type than that of the operation. */
    default boolean mayGiveOtherTypes() {
      return false;
    }
  }
}
