package dev.eventchain.xmi;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;
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

  private final Map<EClass, Boolean> leaves = new IdentityHashMap<>();
  private final List<EObject> found = new ArrayList<>();

  private Contents() {}

  /** Returns the elements of a file, without resolving proxies or entering other files. */
  static List<EObject> of(Resource file) {
    Contents contents = new Contents();
    file.getContents().forEach(contents::addTree);
    return contents.found;
  }

  private void addTree(EObject root) {
    found.add(root);
    Deque<Iterator<EObject>> open = new ArrayDeque<>();
    descend(root, open);
    while (!open.isEmpty()) {
      if (!open.peek().hasNext()) {
        open.pop();
        continue;
      }
      EObject element = open.peek().next();
      if (((InternalEObject) element).eDirectResource() == null) {
        found.add(element);
        descend(element, open);
      }
    }
  }

  private void descend(EObject element, Deque<Iterator<EObject>> open) {
    if (!leaves.computeIfAbsent(element.eClass(), Contents::isLeaf)) {
      open.push(((InternalEList<EObject>) element.eContents()).basicIterator());
    }
  }

  /** Returns whether instances of a class never have children. */
  private static boolean isLeaf(EClass type) {
    return type.getEAllContainments().isEmpty()
        && type.getEAllAttributes().stream().noneMatch(FeatureMapUtil::isFeatureMap);
  }
}
