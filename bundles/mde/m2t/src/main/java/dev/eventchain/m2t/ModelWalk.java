package dev.eventchain.m2t;

import java.util.AbstractList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.util.FeatureMapUtil;

/**
 * Visitor of objects and their contents, parents first, in the order of the model. It reads only
 * containment features, which is faster than EMF's tree iterator.
 */
final class ModelWalk {
  private static final EReference[] UNUSUAL = {};

  private final Consumer<EObject> visitor;
  private final Map<EClass, EReference[]> containments = new HashMap<>();

  /** Class of the previous object; most objects are followed by one of the same class. */
  private EClass latest;

  private EReference[] latestContainments;

  ModelWalk(Consumer<EObject> visitor) {
    this.visitor = visitor;
  }

  void visit(EObject object) {
    visitor.accept(object);
    EClass type = object.eClass();
    if (type != latest) {
      latest = type;
      latestContainments = containments.computeIfAbsent(type, ModelWalk::containments);
    }
    EReference[] features = latestContainments;
    if (features == UNUSUAL) {
      List.copyOf(object.eContents()).forEach(this::visit);
      return;
    }
    for (EReference feature : features) {
      // Some contents of Ecore's own classes count as unset; EMF's iterator skips them, too.
      Object value = object.eIsSet(feature) ? object.eGet(feature) : null;
      if (value instanceof AbstractList<?> contents) {
        for (int i = 0; i < contents.size(); i++) {
          visit((EObject) contents.get(i));
        }
      } else if (value instanceof List<?> contents) {
        List.copyOf(contents).forEach(each -> visit((EObject) each));
      } else if (value != null) {
        visit((EObject) value);
      }
    }
  }

  private static EReference[] containments(EClass type) {
    for (EStructuralFeature feature : type.getEAllStructuralFeatures()) {
      boolean containing = feature instanceof EReference reference && reference.isContainment();
      if (FeatureMapUtil.isFeatureMap(feature) || (containing && feature.isDerived())) {
        return UNUSUAL;
      }
    }
    return type.getEAllContainments().toArray(EReference[]::new);
  }
}
