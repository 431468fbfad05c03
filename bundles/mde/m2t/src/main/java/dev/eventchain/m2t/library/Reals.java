package dev.eventchain.m2t.library;

import java.math.BigDecimal;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.ocl.types.PrimitiveType;

/** The type Real, which excludes Integers in templates. */
public final class Reals {

  private Reals() {}

  /** Returns whether a type is Real. */
  public static boolean isReal(EClassifier type) {
    return type instanceof PrimitiveType<?> primitive
        && primitive.getName().equals(PrimitiveType.REAL_NAME);
  }

  /** Returns whether a value is a Real but not an Integer. */
  public static boolean isRealNumber(Object value) {
    return value instanceof Double || value instanceof Float || value instanceof BigDecimal;
  }
}
