package dev.eventchain.ocl.editing;

import dev.eventchain.editing.ElementKind;
import java.util.List;
import org.eclipse.emf.ecore.EClassifier;

/**
 * Member that can be written after the dot or the arrow behind a value of a type.
 *
 * @param parameters such as {@code index : Integer}; {@code null} for a feature
 * @param type the text of the type of its value; empty if it depends on the call
 * @param origin the class that declares it, or what else it is of; empty if unknown
 * @param element the feature or operation; {@code null} for an operation of a library
 * @param valueType the type of the value; {@code null} if it depends on the call
 */
public record Member(
    String name,
    ElementKind kind,
    List<String> parameters,
    String type,
    String origin,
    Object element,
    EClassifier valueType) {

  /** Returns {@code name(first : Type) : Type} or {@code name : Type}. */
  public String signature() {
    String called = parameters == null ? name : name + "(" + String.join(", ", parameters) + ")";
    return type.isEmpty() ? called : called + " : " + type;
  }
}
