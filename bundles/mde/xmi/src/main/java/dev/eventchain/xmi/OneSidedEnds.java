package dev.eventchain.xmi;

import dev.eventchain.uml.Uml;
import java.util.List;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.emf.ecore.InternalEObject;

/**
 * Completes references of UML of which a file has one end only. EMF's reader drops such an end if
 * its opposite holds several values, since it expects the order from there; UML's files leave out
 * what follows from the other end.
 */
final class OneSidedEnds {

  private final ProjectResources resources;

  OneSidedEnds(ProjectResources resources) {
    this.resources = resources;
  }

  /** Sets what the files say. The references of the files must be resolved. */
  void complete() {
    for (XmiResource file : resources.loaded()) {
      for (Statements.End end : file.statements().ends()) {
        if (Uml.isMetamodel(end.feature().getEContainingClass().getEPackage())) {
          complete(file, end);
        }
      }
    }
  }

  private void complete(XmiResource file, Statements.End end) {
    EReference feature = end.feature();
    EObject target = targetOf(file, end.target());
    if (target == null || !feature.getEType().isInstance(target)) {
      return;
    }
    Object value = end.element().eGet(feature);
    if (!feature.isMany() && value == null) {
      end.element().eSet(feature, target);
    } else if (value instanceof List<?> && !((List<?>) value).contains(target)) {
      add(end.element(), feature, target);
    }
  }

  @SuppressWarnings("unchecked") // EMF's lists have no type arguments
  private static void add(EObject element, EReference feature, EObject target) {
    ((List<EObject>) element.eGet(feature)).add(target);
  }

  private EObject targetOf(XmiResource file, Object target) {
    if (target instanceof String id) {
      return file.getEObject(id);
    }
    EObject element = (EObject) target;
    return element.eIsProxy()
        ? resources.getEObject(((InternalEObject) element).eProxyURI(), false)
        : element;
  }
}
