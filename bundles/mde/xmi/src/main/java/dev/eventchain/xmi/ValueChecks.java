package dev.eventchain.xmi;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.eclipse.emf.ecore.EAttribute;
import org.eclipse.emf.ecore.EDataType;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.util.FeatureMap;
import org.eclipse.emf.ecore.util.FeatureMapUtil;

/** Checks that the values of attributes conform to their data types. */
final class ValueChecks {

  private static final int LONGEST_SHOWN = 80;

  /** The first unchecked value of a type, and the number of unchecked values. */
  private static final class Unchecked {
    private final EObject element;
    private final String feature;
    private long values;

    private Unchecked(EObject element, String feature) {
      this.element = element;
      this.feature = feature;
    }
  }

  private final Function<EObject, SourceLocation> locator;
  private final PatternTime time;
  private final DataTypeLimits limits;
  private final List<Diagnostic> found = new ArrayList<>();
  private final Map<EDataType, Unchecked> unchecked = new LinkedHashMap<>();
  private long evaluations;

  ValueChecks(Function<EObject, SourceLocation> locator, Duration timeLimit) {
    this.locator = locator;
    this.time = new PatternTime(timeLimit);
    this.limits = new DataTypeLimits(time);
  }

  /** Returns the number of checked values. */
  long evaluations() {
    return evaluations;
  }

  /** Returns the findings, including those about unchecked values. */
  List<Diagnostic> findings() {
    List<Diagnostic> all = new ArrayList<>(found);
    unchecked.forEach((type, left) -> all.add(limit(type, left)));
    return all;
  }

  private Diagnostic limit(EDataType type, Unchecked left) {
    return Diagnostic.of(
            EcoreRules.LIMIT,
            "The check of the type `%s` was abandoned at this `%s`: %s. It left %s unchecked."
                .formatted(
                    type.getName(),
                    left.feature,
                    time.shortage(),
                    Coverage.counted(left.values, "value")),
            locator.apply(left.element))
        .withHint(
            "Rewrite its pattern so that a string can match in only one way, or allow more:"
                + " --time-limit SECONDS.");
  }

  /** Checks the values of an attribute. */
  void check(EObject element, EAttribute attribute) {
    if (!element.eIsSet(attribute)) {
      return;
    }
    Object value = element.eGet(attribute, false);
    if (FeatureMapUtil.isFeatureMap(attribute)) {
      for (FeatureMap.Entry entry : ((FeatureMap.Internal) value).basicList()) {
        if (entry.getEStructuralFeature() instanceof EAttribute inner) {
          check(element, inner, entry.getValue());
        }
      }
    } else if (attribute.isMany()) {
      ((List<?>) value).forEach(each -> check(element, attribute, each));
    } else {
      check(element, attribute, value);
    }
  }

  private void check(EObject element, EAttribute attribute, Object value) {
    EDataType type = attribute.getEAttributeType();
    if (value == null || !EcorePlan.isLimited(type)) {
      return;
    }
    try {
      if (!time.isSpent(type)) {
        Optional<String> fault = limits.fault(type, value);
        evaluations++;
        fault.ifPresent(words -> report(element, attribute, value, words));
        return;
      }
    } catch (PatternTime.SpentException e) {
      // Counted like the later ones.
    }
    unchecked.computeIfAbsent(type, each -> new Unchecked(element, attribute.getName())).values++;
  }

  private void report(EObject element, EAttribute attribute, Object value, String fault) {
    String text = String.valueOf(value);
    String shown = text.length() > LONGEST_SHOWN ? text.substring(0, LONGEST_SHOWN) + "..." : text;
    found.add(
        Diagnostic.of(
                EcoreRules.VALUE,
                "`%s` of `%s` %s.".formatted(shown, attribute.getName(), fault),
                locator.apply(element))
            .withHint(
                "The type `%s` of the metamodel defines what is allowed."
                    .formatted(attribute.getEAttributeType().getName())));
  }
}
