package dev.eventchain.ocl.dialect;

import java.util.Optional;
import org.eclipse.emf.ecore.EClassifier;

/** The types of an expression language: their names, construction and comparison. */
public interface TypeSystem {

  /**
   * Returns the type of a valid name.
   *
   * @throws IllegalArgumentException if it is not
   */
  EClassifier type(String name);

  /** Returns the OCL type of a classifier, such as Integer for EInt. */
  EClassifier type(EClassifier classifier);

  /** Returns the type of sequences of an element type. */
  EClassifier sequenceOf(EClassifier elementType);

  /** Returns a collection type of the same kind as another, with another element type. */
  EClassifier collectionLike(EClassifier collectionType, EClassifier elementType);

  /** Returns the element type of a collection type; empty for any other type. */
  Optional<EClassifier> elementType(EClassifier type);

  /** Returns the type that a literal names, given the type of the literal; empty for others. */
  Optional<EClassifier> referredType(EClassifier type);

  /** Returns whether a type conforms to a required type. */
  boolean conforms(EClassifier type, EClassifier required);

  /** Returns whether a value is an instance of a type. */
  boolean isInstance(Object value, EClassifier type);

  /** Returns the type of all values except collections. */
  EClassifier any();

  /** Returns the type of objects of any class. */
  EClassifier anyObject();
}
