package dev.eventchain.m2t.text;

import java.util.Collection;
import org.eclipse.emf.ecore.EEnumLiteral;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;

/** The text that a value has in the output. */
public final class Texts {
  private Texts() {}

  /** Nothing for null; for a collection the texts of its elements, one after the other. */
  public static String of(Object value) {
    if (value instanceof String text) {
      return text;
    }
    if (value == null) {
      return "";
    }
    if (value instanceof Collection<?> elements) {
      StringBuilder text = new StringBuilder();
      elements.forEach(element -> text.append(of(element)));
      return text.toString();
    }
    return value instanceof EObject object && !(value instanceof EEnumLiteral)
        ? label(object)
        : value.toString();
  }

  /** A name for an object: its class, and its name if it has one. The same in each run. */
  public static String label(EObject object) {
    EStructuralFeature name = object.eClass().getEStructuralFeature("name");
    Object value = name == null || name.isMany() ? null : object.eGet(name);
    return object.eClass().getName() + (value == null ? "" : " '" + value + "'");
  }
}
