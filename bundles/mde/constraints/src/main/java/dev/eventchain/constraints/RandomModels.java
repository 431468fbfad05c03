package dev.eventchain.constraints;

import dev.eventchain.ocl.Expression.Navigation;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.eclipse.emf.common.util.EList;
import org.eclipse.emf.ecore.EAttribute;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.emf.ecore.EStructuralFeature;

/**
 * Models with several changes at once, drawn at random among those that may matter to a constraint:
 * of the features that it reads, at the objects that it reaches from an instance of its context, to
 * the literals that it compares with, too. They are what a guard of several conditions needs. The
 * same constraint and model give the same models.
 */
final class RandomModels {

  /** Largest number of changes in a model. */
  private static final int CHANGES = 6;

  /** Largest number of references between an instance of the context and a changed object. */
  private static final int DISTANCE = 3;

  /** Models that the changes start from. */
  private static final int STARTS = 8;

  /** Of this many changes, one is at an object that is not reached from the context. */
  private static final int ELSEWHERE = 5;

  /** Of this many changes, one unsets a feature. */
  private static final int UNSET = 8;

  private final EClass type;
  private final Set<EStructuralFeature> read = new LinkedHashSet<>();
  private final TriedValues values;
  private final Random random;
  private final List<ModelCopy> starts = new ArrayList<>();

  RandomModels(ModelCopy model, OclConstraint constraint, EClass type) {
    this.type = type;
    this.values = new TriedValues(constraint, model);
    this.random = new Random(constraint.qualifiedName().hashCode());
    for (Navigation navigation : constraint.navigations()) {
      read.add(navigation.feature());
    }
    start(model);
    for (ModelChange change : ModelChange.all(model, constraint)) {
      if (starts.size() < STARTS && change.adds()) {
        start(model.with(change));
      }
    }
  }

  /** Takes a model as a start if the constraint has something to say about it. */
  private void start(ModelCopy model) {
    if (!model.instancesOf(type).isEmpty()) {
      starts.add(model);
    }
  }

  /** Returns whether there are any: not if no change creates an instance of the context. */
  boolean areThere() {
    return !starts.isEmpty() && !read.isEmpty();
  }

  /** Returns the next model. */
  ModelCopy next() {
    return pick(starts)
        .with(
            copy -> {
              for (int left = 1 + random.nextInt(CHANGES); left > 0; left--) {
                change(copy);
              }
            });
  }

  private void change(ModelCopy copy) {
    EObject object = random.nextInt(ELSEWHERE) == 0 ? pick(copy.objects()) : reached(copy);
    List<EStructuralFeature> features =
        object.eClass().getEAllStructuralFeatures().stream()
            .filter(read::contains)
            .filter(ModelChange::isPossible)
            .toList();
    if (features.isEmpty()) {
      return;
    }
    EStructuralFeature feature = pick(features);
    if (random.nextInt(UNSET) == 0) {
      object.eUnset(feature);
    } else if (feature instanceof EAttribute attribute) {
      put(object, feature, values.of(attribute));
    } else if (feature instanceof EReference reference && reference.isContainment()) {
      ExtremeValues.Extreme extreme = pick(List.of(ExtremeValues.Extreme.values()));
      put(object, feature, ExtremeValues.filled(reference, extreme, copy).stream().toList());
    } else {
      put(object, feature, copy.instancesOf(((EReference) feature).getEReferenceType()));
    }
  }

  /** Returns an object that the constraint may reach from an instance of its context. */
  private EObject reached(ModelCopy copy) {
    EObject object = pick(copy.instancesOf(type));
    for (int left = random.nextInt(DISTANCE + 1); left > 0; left--) {
      List<EObject> next = new ArrayList<>();
      for (EStructuralFeature feature : object.eClass().getEAllStructuralFeatures()) {
        if (feature instanceof EReference && read.contains(feature)) {
          addTargets(object.eGet(feature), next);
        }
      }
      if (next.isEmpty()) {
        return object;
      }
      object = pick(next);
    }
    return object;
  }

  private static void addTargets(Object value, List<EObject> targets) {
    if (value instanceof EObject one) {
      targets.add(one);
    } else if (value instanceof Collection<?> several) {
      several.forEach(each -> addTargets(each, targets));
    }
  }

  @SuppressWarnings("unchecked")
  private void put(EObject owner, EStructuralFeature feature, List<?> choices) {
    if (choices.isEmpty()) {
      return;
    }
    Object value = pick(choices);
    if (!feature.isMany()) {
      owner.eSet(feature, value);
      return;
    }
    EList<Object> all = (EList<Object>) owner.eGet(feature);
    if (random.nextBoolean()) {
      all.clear();
    }
    all.add(value);
  }

  private <T> T pick(List<T> choices) {
    return choices.get(random.nextInt(choices.size()));
  }
}
