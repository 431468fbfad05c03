package dev.eventchain.eclipse.ui.editor;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;

/**
 * Names for the elements of a tree by which findings say what they are about. Two trees that hold
 * the same have the same names; their order is that of the tree.
 */
final class ElementKeys {

  private final List<EObject> elements = new ArrayList<>();
  private final Map<EObject, Integer> numbers = new IdentityHashMap<>();

  ElementKeys(EObject root) {
    add(root);
    root.eAllContents().forEachRemaining(this::add);
  }

  private void add(EObject element) {
    numbers.put(element, elements.size());
    elements.add(element);
  }

  List<EObject> elements() {
    return elements;
  }

  SourceLocation locate(EObject element) {
    return SourceLocation.NONE.withElement("%08d".formatted(numbers.getOrDefault(element, 0)));
  }

  SourceLocation locate(EObject element, EStructuralFeature feature) {
    SourceLocation place = locate(element);
    return place.withElement(place.element() + "." + feature.getName());
  }

  /** A finding with the element that its location names: the root if it is about another place. */
  ElementFinding about(Diagnostic finding) {
    String[] key = finding.location().element().split("\\.", 2);
    boolean known = key[0].matches("\\d{8}") && finding.location().file().isEmpty();
    EObject element = elements.get(known ? Integer.parseInt(key[0]) : 0);
    EStructuralFeature feature =
        known && key.length == 2 ? element.eClass().getEStructuralFeature(key[1]) : null;
    return new ElementFinding(finding, element, feature);
  }
}
