package dev.eventchain.xmi;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.emf.ecore.InternalEObject;
import org.eclipse.emf.ecore.resource.Resource;
import org.eclipse.emf.ecore.util.FeatureMapUtil;
import org.eclipse.emf.ecore.util.InternalEList;

/**
 * The elements of files in the order of containment. EMF's own iterator asks each element for a
 * list of its children, which the element then keeps: for most elements of a large model an empty
 * one.
 */
final class Contents {

  /**
   * Access to the children of the instances of a class.
   *
   * @param references those that contain children, from last to first
   * @param elsewhere true if feature maps may contain children, too
   */
  private record Plan(List<EReference> references, boolean elsewhere) {
    static Plan of(EClass type) {
      List<EReference> references = new ArrayList<>();
      for (EReference reference : type.getEAllContainments()) {
        if (!reference.isDerived()) {
          references.add(0, reference);
        }
      }
      return new Plan(
          references, type.getEAllAttributes().stream().anyMatch(FeatureMapUtil::isFeatureMap));
    }
  }

  private final Map<EClass, Plan> plans = new HashMap<>();
  private final List<EObject> found = new ArrayList<>();
  private final Deque<Iterator<EObject>> open = new ArrayDeque<>();

  private Contents() {}

  /** Returns the elements of a file, without resolving proxies or entering other files. */
  static List<EObject> of(Resource file) {
    Contents contents = new Contents();
    file.getContents().forEach(contents::addTree);
    return contents.found;
  }

  private void addTree(EObject root) {
    found.add(root);
    descend(root);
    while (!open.isEmpty()) {
      if (!open.peek().hasNext()) {
        open.pop();
        continue;
      }
      EObject element = open.peek().next();
      if (((InternalEObject) element).eDirectResource() == null) {
        found.add(element);
        descend(element);
      }
    }
  }

  private void descend(EObject element) {
    Plan plan = plans.computeIfAbsent(element.eClass(), Plan::of);
    if (plan.elsewhere()) {
      open.push(((InternalEList<EObject>) element.eContents()).basicIterator());
      return;
    }
    for (EReference reference : plan.references()) {
      if (element.eIsSet(reference)) {
        open.push(childrenIn(element.eGet(reference, false)));
      }
    }
  }

  @SuppressWarnings("unchecked") // EMF's lists have no type arguments
  private static Iterator<EObject> childrenIn(Object value) {
    return value instanceof InternalEList<?> list
        ? ((InternalEList<EObject>) list).basicIterator()
        : List.of((EObject) value).iterator();
  }
}
