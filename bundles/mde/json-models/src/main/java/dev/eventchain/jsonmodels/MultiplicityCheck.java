package dev.eventchain.jsonmodels;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Rule;
import java.util.List;
import java.util.Locale;
import org.eclipse.emf.ecore.EAttribute;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;

/** Checks that each feature of an object has as many values as its multiplicity requires. */
final class MultiplicityCheck {

  private final InstanceObjects objects;
  private final List<Diagnostic> findings;

  MultiplicityCheck(InstanceObjects objects, List<Diagnostic> findings) {
    this.objects = objects;
    this.findings = findings;
  }

  void check(EObject object) {
    for (EStructuralFeature feature : object.eClass().getEAllStructuralFeatures()) {
      if (!InstanceObjects.isWritable(feature) || feature.isTransient()) {
        continue;
      }
      if (feature.isMany()) {
        checkCount(object, feature, ((List<?>) object.eGet(feature)).size());
      } else if (feature.isRequired() && isMissing(object, feature)) {
        report(
            object,
            feature,
            InstanceRules.FEATURE_MISSING,
            "'" + feature.getName() + "' is missing.");
      }
    }
  }

  /** Returns whether a feature is missing: neither given, even if invalid, nor with a default. */
  private boolean isMissing(EObject object, EStructuralFeature feature) {
    if (objects.isGiven(object, feature)) {
      return false;
    }
    return feature instanceof EAttribute
        ? feature.getDefaultValueLiteral() == null
        : object.eGet(feature) == null;
  }

  private void checkCount(EObject object, EStructuralFeature feature, int count) {
    int upper = feature.getUpperBound();
    boolean tooFew = count < feature.getLowerBound();
    boolean tooMany = upper >= 0 && count > upper;
    if (count == 0 && tooFew && !objects.isGiven(object, feature)) {
      report(
          object,
          feature,
          InstanceRules.FEATURE_MISSING,
          "'" + feature.getName() + "' is missing.");
    } else if (tooFew || tooMany) {
      String limit = tooFew ? "at least " + feature.getLowerBound() : "at most " + upper;
      report(
          object,
          feature,
          InstanceRules.MULTIPLICITY,
          String.format(
              Locale.ROOT, "'%s' takes %s values, not %d.", feature.getName(), limit, count));
    }
  }

  private void report(EObject object, EStructuralFeature feature, Rule rule, String message) {
    findings.add(Diagnostic.of(rule, message, objects.placeOf(object, feature)));
  }
}
