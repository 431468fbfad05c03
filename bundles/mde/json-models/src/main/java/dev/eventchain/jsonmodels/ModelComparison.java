package dev.eventchain.jsonmodels;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.eclipse.emf.ecore.EAttribute;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EReference;

/** Compares two models of the same metamodel. Models made independently check each other. */
public final class ModelComparison {

  private final Function<EObject, SourceLocation> locator;
  private final ModelMatch match;
  private final List<Diagnostic> differences = new ArrayList<>();

  private ModelComparison(ModelMatch match, Function<EObject, SourceLocation> locator) {
    this.match = match;
    this.locator = locator;
  }

  /**
   * Returns the differences between two models.
   *
   * @param expected the root of the reference model
   * @param actual the root of the compared model
   * @param locator the places of the elements of {@code actual}
   * @return errors for different, missing or additional elements and values, warnings for another
   *     order in ordered features; empty if the models are equal
   */
  public static List<Diagnostic> compare(
      EObject expected, EObject actual, Function<EObject, SourceLocation> locator) {
    ModelComparison comparison = new ModelComparison(new ModelMatch(expected, actual), locator);
    comparison.compareObjects(expected, actual);
    return comparison.differences.stream().sorted().toList();
  }

  private void compareObjects(EObject expected, EObject actual) {
    if (expected.eClass() != actual.eClass()) {
      report(
          actual,
          InstanceRules.COMPARISON_CLASS,
          "This is a %s, not a %s."
              .formatted(actual.eClass().getName(), expected.eClass().getName()));
      return;
    }
    for (EAttribute attribute : expected.eClass().getEAllAttributes()) {
      if (!attribute.isDerived()) {
        compareAttribute(expected, actual, attribute);
      }
    }
    for (EReference reference : expected.eClass().getEAllReferences()) {
      if (reference.isContainment()) {
        compareContents(expected, actual, reference);
      } else if (!reference.isContainer() && !reference.isDerived()) {
        compareReference(expected, actual, reference);
      }
    }
  }

  private void compareAttribute(EObject expected, EObject actual, EAttribute attribute) {
    boolean wanted = !attribute.isUnsettable() || expected.eIsSet(attribute);
    boolean there = !attribute.isUnsettable() || actual.eIsSet(attribute);
    Object wantedValue = wanted ? comparable(expected, attribute) : null;
    Object thereValue = there ? comparable(actual, attribute) : null;
    if (!Objects.equals(wantedValue, thereValue)) {
      report(
          actual,
          InstanceRules.COMPARISON_VALUE,
          "'%s' is %s, not %s."
              .formatted(attribute.getName(), shown(thereValue), shown(wantedValue)));
    }
  }

  private static Object comparable(EObject object, EAttribute attribute) {
    Object value = object.eGet(attribute);
    if (value instanceof List<?> list && !attribute.isOrdered()) {
      return list.stream().map(String::valueOf).sorted().toList();
    }
    return value instanceof List<?> list ? new ArrayList<>(list) : value;
  }

  private void compareContents(EObject expected, EObject actual, EReference reference) {
    List<EObject> wanted = ModelMatch.values(expected, reference);
    List<EObject> there = ModelMatch.values(actual, reference);
    List<EObject> partners = new ArrayList<>();
    for (EObject child : wanted) {
      EObject partner = match.partner(child);
      if (partner == null) {
        report(
            actual,
            InstanceRules.COMPARISON_MISSING,
            "'%s' lacks the %s.".formatted(reference.getName(), ModelMatch.describe(child)));
      } else {
        partners.add(partner);
        compareObjects(child, partner);
      }
    }
    Set<EObject> matched = new HashSet<>(partners);
    for (EObject child : there) {
      if (!matched.contains(child)) {
        report(
            child,
            InstanceRules.COMPARISON_ADDITIONAL,
            "'%s' has this %s in addition."
                .formatted(reference.getName(), ModelMatch.describe(child)));
      }
    }
    List<EObject> common = there.stream().filter(matched::contains).toList();
    if (reference.isOrdered() && !common.equals(partners)) {
      reportOrder(actual, reference, partners);
    }
  }

  private void compareReference(EObject expected, EObject actual, EReference reference) {
    List<EObject> wanted =
        ModelMatch.values(expected, reference).stream().map(match::counterpart).toList();
    List<EObject> there = ModelMatch.values(actual, reference);
    List<EObject> missing = wanted.stream().filter(value -> !there.contains(value)).toList();
    List<EObject> additional = there.stream().filter(value -> !wanted.contains(value)).toList();
    if (!missing.isEmpty() || !additional.isEmpty()) {
      boolean alike = names(there).equals(names(wanted));
      String message =
          "'%s' refers to %s, not to %s."
              .formatted(
                  reference.getName(),
                  alike ? places(additional) : names(there),
                  alike ? places(missing) : names(wanted));
      report(actual, InstanceRules.COMPARISON_REFERENCE, message);
    } else if (reference.isOrdered() && !wanted.equals(there)) {
      reportOrder(actual, reference, wanted);
    }
  }

  private static String names(List<EObject> objects) {
    return objects.isEmpty()
        ? "nothing"
        : objects.stream().map(ModelMatch::describe).collect(Collectors.joining(", "));
  }

  /** Returns the names of elements with the same name, with their distinguishing details. */
  private static String places(List<EObject> objects) {
    if (objects.isEmpty()) {
      return "nothing";
    }
    return objects.stream().map(ModelComparison::place).collect(Collectors.joining(", "));
  }

  private static String place(EObject object) {
    String name = ModelMatch.describe(object);
    if (object.eContainer() == null) {
      return name;
    }
    EReference feature = object.eContainmentFeature();
    int number = ModelMatch.values(object.eContainer(), feature).indexOf(object) + 1;
    return String.format(Locale.ROOT, "%s (number %d in '%s')", name, number, feature.getName());
  }

  private void reportOrder(EObject actual, EReference reference, List<EObject> wanted) {
    differences.add(
        Diagnostic.of(
            InstanceRules.COMPARISON_ORDER,
            "'%s' is in a different order; expected: %s."
                .formatted(reference.getName(), names(wanted)),
            locator.apply(actual)));
  }

  private void report(EObject actual, Rule rule, String message) {
    differences.add(Diagnostic.of(rule, message, locator.apply(actual)));
  }

  private static String shown(Object value) {
    if (value == null) {
      return "not set";
    }
    return value instanceof String ? "'" + value + "'" : value.toString();
  }
}
