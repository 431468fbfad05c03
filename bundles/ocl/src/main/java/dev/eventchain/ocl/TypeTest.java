package dev.eventchain.ocl;

import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.ocl.types.InvalidType;
import org.eclipse.ocl.types.VoidType;

/**
 * Whether values are of a type, with Eclipse OCL's lax answers for null and invalid.
 *
 * @param exactly whether instances of subtypes are left out
 */
record TypeTest(EClassifier type, boolean exactly, ValueEnvironment environment) {

  /** What {@code oclIsKindOf} or {@code oclIsTypeOf} says. */
  boolean holds(Object value) {
    if (value == null) {
      return exactly ? type instanceof VoidType<?> : !(type instanceof InvalidType<?>);
    } else if (value == Node.INVALID) {
      return !exactly || type instanceof InvalidType<?>;
    }
    return exactly ? environment.isTypeOf(value, type) : environment.isKindOf(value, type);
  }

  /** Whether {@code selectByKind} or {@code selectByType} takes an element. */
  boolean selects(Object element) {
    return exactly ? holds(element) : element != null && holds(element);
  }
}
