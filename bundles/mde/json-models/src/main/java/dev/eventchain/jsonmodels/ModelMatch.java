package dev.eventchain.jsonmodels;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.function.BiPredicate;
import org.eclipse.emf.ecore.EAttribute;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.emf.ecore.EStructuralFeature;

/**
 * The matching of the elements of two models, by containment feature. First match elements with
 * equal attributes and contents (at the same position, so that equal elements match one to one,
 * then at any). Then follow those with equal attributes, with equal names, and at the same
 * position.
 */
final class ModelMatch {

  private static final int DEEPEST_COMPARISON = 50;

  private final Map<EObject, EObject> partners = new HashMap<>();

  ModelMatch(EObject expected, EObject actual) {
    pair(expected, actual);
  }

  /** Returns the element of the other model; null if there is none. */
  EObject partner(EObject expected) {
    return partners.get(expected);
  }

  /** Returns the element of the other model, or the element itself if it is in neither model. */
  EObject counterpart(EObject expected) {
    return partners.getOrDefault(expected, expected);
  }

  private void pair(EObject expected, EObject actual) {
    partners.put(expected, actual);
    if (expected.eClass() == actual.eClass()) {
      for (EReference reference : expected.eClass().getEAllContainments()) {
        pairContents(values(expected, reference), values(actual, reference));
      }
    }
  }

  private void pairContents(List<EObject> expected, List<EObject> actual) {
    Set<EObject> open = new LinkedHashSet<>(actual);
    List<EObject> rest = new ArrayList<>(expected);
    pairAtSamePosition(expected, actual, rest, open);
    pairIf((a, b) -> sameContents(a, b, 0), rest, open);
    pairIf(ModelMatch::sameAttributes, rest, open);
    pairIf((a, b) -> !name(a).isEmpty() && name(a).equals(name(b)), rest, open);
    pairIf((a, b) -> true, rest, open);
  }

  private void pairAtSamePosition(
      List<EObject> expected, List<EObject> actual, List<EObject> rest, Set<EObject> open) {
    for (int i = 0; i < Math.min(expected.size(), actual.size()); i++) {
      if (sameContents(expected.get(i), actual.get(i), 0)) {
        rest.remove(expected.get(i));
        open.remove(actual.get(i));
        pair(expected.get(i), actual.get(i));
      }
    }
  }

  private void pairIf(BiPredicate<EObject, EObject> same, List<EObject> rest, Set<EObject> open) {
    List<EObject> unpaired = new ArrayList<>();
    for (EObject expected : rest) {
      EObject found = null;
      for (EObject candidate : open) {
        if (candidate.eClass() == expected.eClass() && same.test(expected, candidate)) {
          found = candidate;
          break;
        }
      }
      if (found == null) {
        unpaired.add(expected);
      } else {
        open.remove(found);
        pair(expected, found);
      }
    }
    rest.clear();
    rest.addAll(unpaired);
  }

  private static boolean sameContents(EObject first, EObject second, int depth) {
    if (first.eClass() != second.eClass() || !sameAttributes(first, second)) {
      return false;
    }
    if (depth > DEEPEST_COMPARISON) {
      return true;
    }
    for (EReference reference : first.eClass().getEAllContainments()) {
      List<EObject> one = values(first, reference);
      List<EObject> other = values(second, reference);
      if (one.size() != other.size()) {
        return false;
      }
      for (int i = 0; i < one.size(); i++) {
        if (!sameContents(one.get(i), other.get(i), depth + 1)) {
          return false;
        }
      }
    }
    return true;
  }

  private static boolean sameAttributes(EObject first, EObject second) {
    for (EAttribute attribute : first.eClass().getEAllAttributes()) {
      if (!attribute.isDerived()
          && (first.eIsSet(attribute) != second.eIsSet(attribute)
              || !Objects.equals(first.eGet(attribute), second.eGet(attribute)))) {
        return false;
      }
    }
    return true;
  }

  /** Returns the values of a reference, as a list also if it is single-valued. */
  static List<EObject> values(EObject object, EReference reference) {
    Object value = object.eGet(reference);
    if (value instanceof List<?> list) {
      return list.stream().map(EObject.class::cast).toList();
    }
    return value == null ? List.of() : List.of((EObject) value);
  }

  /** Returns the class of an element and its name, if it has one. */
  static String describe(EObject object) {
    String name = name(object);
    return object.eClass().getName() + (name.isEmpty() ? "" : " '" + name + "'");
  }

  private static String name(EObject object) {
    EStructuralFeature key = object.eClass().getEIDAttribute();
    for (String candidate : List.of("name", "id")) {
      key = key == null ? object.eClass().getEStructuralFeature(candidate) : key;
    }
    Object value = key instanceof EAttribute && !key.isMany() ? object.eGet(key) : null;
    return value == null ? "" : value.toString();
  }
}
