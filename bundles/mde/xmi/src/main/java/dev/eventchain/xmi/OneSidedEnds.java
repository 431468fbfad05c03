package dev.eventchain.xmi;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.uml.Uml;
import java.util.List;
import java.util.Optional;
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
    if (holds(end.element(), feature, target)) {
      return;
    }
    Optional<EObject> other =
        single(end.element(), feature).or(() -> single(target, feature.getEOpposite()));
    if (other.isPresent()) {
      file.statements().addFault(contradiction(file, end, target, other.get()));
    } else if (feature.isMany()) {
      add(end.element(), feature, target);
    } else {
      end.element().eSet(feature, target);
    }
  }

  private static boolean holds(EObject element, EReference feature, EObject target) {
    Object value = element.eGet(feature);
    return value == target || (value instanceof List<?> values && values.contains(target));
  }

  /** Returns the value of a feature that holds one, if it is set. */
  private static Optional<EObject> single(EObject element, EReference feature) {
    return feature.isMany()
        ? Optional.empty()
        : Optional.ofNullable((EObject) element.eGet(feature));
  }

  private static Diagnostic contradiction(
      XmiResource file, Statements.End end, EObject written, EObject other) {
    String message =
        "`%s` of %s is %s here, which contradicts %s."
            .formatted(
                end.feature().getName(),
                ModelPath.of(end.element()),
                ModelPath.of(written),
                ModelPath.of(other));
    return Diagnostic.of(EcoreRules.OPPOSITE, message, file.problems().text().at(end.tag()))
        .withHint("Name it at both ends in the same way, or at one of them only.");
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
