package dev.eventchain.m2t.text;

import java.util.Collection;
import org.eclipse.emf.ecore.EEnumLiteral;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;

/** Texts of values in the output. */
public final class Texts {
  private Texts() {}

  /**
   * Returns the text of a value: empty for null, the concatenated texts of the elements for a
   * collection.
   */
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

  /** Returns a label of an object: its class, and its name if it has one. Equal in all runs. */
  public static String label(EObject object) {
    EStructuralFeature name = object.eClass().getEStructuralFeature("name");
    Object value = name == null || name.isMany() ? null : object.eGet(name);
    return object.eClass().getName() + (value == null ? "" : " '" + value + "'");
  }
}
