package dev.eventchain.xmi;

import java.util.List;
import org.eclipse.emf.ecore.EAttribute;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.EcorePackage;

/** Readable paths of elements: {@code EventChain[aeb]/software[TTC_Calculation]/measured}. */
final class ModelPath {

  private ModelPath() {}

  /** Returns the path from the root of the containment tree to the element. */
  static String of(EObject element) {
    StringBuilder path = new StringBuilder();
    EObject step = element;
    while (step.eContainer() != null && step.eContainer() != step) {
      path.insert(0, "/" + step.eContainmentFeature().getName() + label(step));
      step = step.eContainer();
    }
    return path.insert(0, step.eClass().getName() + label(step)).toString();
  }

  /** Returns the name in brackets, else the position if there can be several, else nothing. */
  private static String label(EObject element) {
    String name = nameOf(element);
    if (!name.isEmpty()) {
      return "[" + name + "]";
    }
    EStructuralFeature feature = element.eContainmentFeature();
    if (feature == null || !feature.isMany()) {
      return "";
    }
    return "[" + ((List<?>) element.eContainer().eGet(feature)).indexOf(element) + "]";
  }

  /** Returns the value of the id attribute, else of a text attribute {@code name} or {@code id}. */
  private static String nameOf(EObject element) {
    EAttribute id = element.eClass().getEIDAttribute();
    String name = textOf(element, id);
    if (name.isEmpty()) {
      name = textOf(element, element.eClass().getEStructuralFeature("name"));
    }
    return name.isEmpty() ? textOf(element, element.eClass().getEStructuralFeature("id")) : name;
  }

  private static String textOf(EObject element, EStructuralFeature feature) {
    boolean text =
        feature instanceof EAttribute attribute
            && !attribute.isMany()
            && attribute.getEAttributeType() == EcorePackage.Literals.ESTRING;
    Object value = text ? element.eGet(feature) : null;
    return value == null ? "" : value.toString();
  }
}
