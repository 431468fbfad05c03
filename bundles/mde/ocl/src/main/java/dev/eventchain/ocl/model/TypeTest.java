package dev.eventchain.ocl.model;

import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.ocl.types.VoidType;

/**
 * A test of values for a type.
 *
 * @param exactly true to exclude instances of subtypes
 */
public record TypeTest(EClassifier type, boolean exactly, ModelAccess environment) {

  /** Returns the result of {@code oclIsKindOf} or {@code oclIsTypeOf} for a defined value. */
  public boolean holds(Object value) {
    return exactly ? environment.isTypeOf(value, type) : environment.isKindOf(value, type);
  }

  /** Returns whether {@code selectByKind} or {@code selectByType} selects an element. */
  public boolean selects(Object element) {
    return element == null ? exactly && type instanceof VoidType<?> : holds(element);
  }
}
