package dev.eventchain.ocl.model;

import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.ocl.types.VoidType;

/**
 * Whether values are of a type.
 *
 * @param exactly whether instances of subtypes are left out
 */
public record TypeTest(EClassifier type, boolean exactly, ModelAccess environment) {

  /** What {@code oclIsKindOf} or {@code oclIsTypeOf} says of a value that is not undefined. */
  public boolean holds(Object value) {
    return exactly ? environment.isTypeOf(value, type) : environment.isKindOf(value, type);
  }

  /** Whether {@code selectByKind} or {@code selectByType} takes an element. */
  public boolean selects(Object element) {
    return element == null ? exactly && type instanceof VoidType<?> : holds(element);
  }
}
