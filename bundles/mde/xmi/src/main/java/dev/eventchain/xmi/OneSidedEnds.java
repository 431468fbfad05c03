package dev.eventchain.xmi;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.uml.Uml;
import java.util.List;
import java.util.Optional;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EReference;

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
      Ends ends = file.statements().ends();
      for (int end = 0; end < ends.size(); end++) {
        if (Uml.isMetamodel(ends.feature(end).getEContainingClass().getEPackage())) {
          complete(file, ends, end);
        }
      }
    }
  }

  private static void complete(XmiResource file, Ends ends, int end) {
    EReference feature = ends.feature(end);
    EObject element = ends.element(end);
    EObject target = file.targetOf(ends.target(end));
    if (target == null || !feature.getEType().isInstance(target)) {
      return;
    }
    if (holds(element, feature, target)) {
      return;
    }
    Optional<EObject> other =
        single(element, feature).or(() -> single(target, feature.getEOpposite()));
    if (other.isPresent()) {
      file.statements().addFault(contradiction(file, ends, end, target, other.get()));
    } else if (feature.isMany()) {
      add(element, feature, target);
    } else {
      element.eSet(feature, target);
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
      XmiResource file, Ends ends, int end, EObject written, EObject other) {
    String message =
        "`%s` of %s is %s here, which contradicts %s."
            .formatted(
                ends.feature(end).getName(),
                ModelPath.of(ends.element(end)),
                ModelPath.of(written),
                ModelPath.of(other));
    return Diagnostic.of(EcoreRules.OPPOSITE, message, file.problems().text().at(ends.tag(end)))
        .withHint("Name it at both ends in the same way, or at one of them only.");
  }

  @SuppressWarnings("unchecked") // EMF's lists have no type arguments
  private static void add(EObject element, EReference feature, EObject target) {
    ((List<EObject>) element.eGet(feature)).add(target);
  }
}
