package dev.eventchain.jsonmodels;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import java.util.List;
import java.util.Optional;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.emf.ecore.util.EcoreUtil;

/** Sets a reference after checking what EMF would repair silently or fail on. */
final class Assignment {

  private final EObject source;
  private final EReference reference;
  private final EObject target;

  private Assignment(EObject source, EReference reference, EObject target) {
    this.source = source;
    this.reference = reference;
    this.target = target;
  }

  static Assignment of(EObject source, EReference reference, EObject target) {
    return new Assignment(source, reference, target);
  }

  /** Sets the reference; returns a finding without place if it cannot be set. */
  Optional<Diagnostic> make() {
    Optional<Diagnostic> problem = problem();
    if (problem.isPresent()) {
      return problem;
    }
    if (reference.isMany()) {
      @SuppressWarnings("unchecked") // A many-valued reference holds a list of objects.
      List<EObject> values = (List<EObject>) source.eGet(reference);
      if (!reference.isUnique() || !values.contains(target)) {
        values.add(target);
      }
    } else {
      source.eSet(reference, target);
    }
    return Optional.empty();
  }

  private Optional<Diagnostic> problem() {
    if (!reference.getEReferenceType().isInstance(target)) {
      return found(
          InstanceRules.REFERENCE_TYPE,
          "Feature '%s' takes objects of class %s, not %s."
              .formatted(
                  reference.getName(),
                  reference.getEReferenceType().getName(),
                  target.eClass().getName()));
    }
    if (!reference.isMany() && source.eGet(reference) != null && source.eGet(reference) != target) {
      return found(
          InstanceRules.MULTIPLICITY,
          "Feature '%s' takes one value and already has another.".formatted(reference.getName()));
    }
    if (reference.isContainment()) {
      return containmentProblem(source, target);
    }
    return reference.isContainer() ? containmentProblem(target, source) : Optional.empty();
  }

  private Optional<Diagnostic> containmentProblem(EObject container, EObject content) {
    if (EcoreUtil.isAncestor(content, container)) {
      return found(
          InstanceRules.CONTAINMENT_CYCLE,
          "The %s would contain itself.".formatted(content.eClass().getName()));
    }
    EReference feature = reference.isContainment() ? reference : reference.getEOpposite();
    boolean elsewhere =
        content.eContainer() != null
            && (content.eContainer() != container || content.eContainmentFeature() != feature);
    return elsewhere
        ? found(
            InstanceRules.CONTAINMENT_SEVERAL,
            "The %s is already in the feature '%s' of a %s."
                .formatted(
                    content.eClass().getName(),
                    content.eContainmentFeature().getName(),
                    content.eContainer().eClass().getName()))
        : Optional.empty();
  }

  private static Optional<Diagnostic> found(Rule rule, String message) {
    return Optional.of(Diagnostic.of(rule, message, SourceLocation.NONE));
  }
}
