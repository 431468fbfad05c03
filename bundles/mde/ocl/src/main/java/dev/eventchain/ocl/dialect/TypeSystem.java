package dev.eventchain.ocl.dialect;

import java.util.Optional;
import org.eclipse.emf.ecore.EClassifier;

/** The types of an expression language: how they are named, made of each other and compared. */
public interface TypeSystem {

  /**
   * The type of a name that is known to be right.
   *
   * @throws IllegalArgumentException if it is not
   */
  EClassifier type(String name);

  /** The type under which OCL knows a classifier: its own Integer for EInt, for instance. */
  EClassifier type(EClassifier classifier);

  /** The type of sequences of this type of elements. */
  EClassifier sequenceOf(EClassifier elementType);

  /** A collection type of the same kind as another one, for other elements. */
  EClassifier collectionLike(EClassifier collectionType, EClassifier elementType);

  /** The type of the elements of a collection type; empty for any other type. */
  Optional<EClassifier> elementType(EClassifier type);

  /** The type that a type literal names, given the type of the literal; empty for other types. */
  Optional<EClassifier> referredType(EClassifier type);

  /** Whether every value of a type can be where the other type is asked for. */
  boolean conforms(EClassifier type, EClassifier required);

  /** Whether a value is an instance of a type. */
  boolean isInstance(Object value, EClassifier type);

  /** The type of everything but collections. */
  EClassifier any();

  /** The type of objects of any class. */
  EClassifier anyObject();
}
