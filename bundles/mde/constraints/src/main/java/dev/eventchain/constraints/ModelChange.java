package dev.eventchain.constraints;

import dev.eventchain.ocl.Expression.Navigation;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import org.eclipse.emf.common.util.EList;
import org.eclipse.emf.ecore.EAttribute;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.emf.ecore.EStructuralFeature;

/**
 * One change of one feature of one object.
 *
 * @param object the object's position in its model
 * @param feature the feature that is changed
 * @param value the new value
 */
record ModelChange(int object, EStructuralFeature feature, NewValue value) {
  /** Creates the new value of a feature from objects of the changed model. */
  private interface NewValue {
    void set(ModelCopy model, EObject object, EStructuralFeature feature);
  }

  /** Number of objects added to test an upper bound on their number. */
  private static final int MANY = 20;

  /** Maximal number of other targets that are tried for a reference. */
  private static final int TARGETS = 6;

  void apply(ModelCopy model) {
    value.set(model, model.objects().get(object), feature);
  }

  /**
   * Returns all changes, first of the features that a constraint reads, then of the other features
   * of the model.
   */
  static List<ModelChange> all(ModelCopy model, OclConstraint constraint) {
    Set<EStructuralFeature> read = new LinkedHashSet<>();
    for (Navigation navigation : constraint.navigations()) {
      read.add(navigation.feature());
    }
    TriedValues values = new TriedValues(constraint, model);
    List<ModelChange> changes = new ArrayList<>();
    addChanges(changes, model, values, read::contains);
    addChanges(
        changes, model, values, feature -> isContainment(feature) && !read.contains(feature));
    return changes;
  }

  private static void addChanges(
      List<ModelChange> changes,
      ModelCopy model,
      TriedValues values,
      Predicate<EStructuralFeature> wanted) {
    for (int i = 0; i < model.objects().size(); i++) {
      for (EStructuralFeature feature :
          model.objects().get(i).eClass().getEAllStructuralFeatures()) {
        if (isPossible(feature) && wanted.test(feature)) {
          addChanges(changes, i, feature, model, values);
        }
      }
    }
  }

  /** Returns whether a feature can be set; containers change with what they contain. */
  static boolean isPossible(EStructuralFeature feature) {
    boolean container = feature instanceof EReference reference && reference.isContainer();
    return feature.isChangeable() && !feature.isDerived() && !container;
  }

  /** Returns whether it may add an object. */
  boolean adds() {
    return isContainment(feature);
  }

  private static boolean isContainment(EStructuralFeature feature) {
    return feature instanceof EReference reference && reference.isContainment();
  }

  private static void addChanges(
      List<ModelChange> changes,
      int object,
      EStructuralFeature feature,
      ModelCopy model,
      TriedValues values) {
    changes.add(new ModelChange(object, feature, (copy, owner, f) -> owner.eUnset(f)));
    if (feature instanceof EAttribute attribute) {
      for (Object tried : values.of(attribute)) {
        changes.add(new ModelChange(object, feature, (copy, owner, f) -> put(owner, f, tried)));
      }
    } else if (feature instanceof EReference reference && isContainment(feature)) {
      addContained(changes, object, reference);
    } else if (feature instanceof EReference reference) {
      addTargets(changes, object, reference, model);
    }
  }

  private static void addContained(List<ModelChange> changes, int object, EReference reference) {
    for (ExtremeValues.Extreme extreme : ExtremeValues.Extreme.values()) {
      for (int count : reference.isMany() ? new int[] {1, MANY} : new int[] {1}) {
        changes.add(
            new ModelChange(
                object,
                reference,
                (copy, owner, f) -> {
                  for (int i = 0; i < count; i++) {
                    ExtremeValues.filled((EReference) f, extreme, copy)
                        .ifPresent(part -> put(owner, f, part));
                  }
                }));
      }
    }
  }

  private static void addTargets(
      List<ModelChange> changes, int object, EReference reference, ModelCopy model) {
    EClass type = reference.getEReferenceType();
    int number = Math.min(TARGETS, model.instancesOf(type).size());
    for (int i = 0; i < number; i++) {
      int target = i;
      changes.add(
          new ModelChange(
              object,
              reference,
              (copy, owner, f) -> put(owner, f, copy.instancesOf(type).get(target))));
    }
  }

  @SuppressWarnings("unchecked")
  private static void put(EObject owner, EStructuralFeature feature, Object value) {
    if (feature.isMany()) {
      ((EList<Object>) owner.eGet(feature)).add(value);
    } else {
      owner.eSet(feature, value);
    }
  }
}
