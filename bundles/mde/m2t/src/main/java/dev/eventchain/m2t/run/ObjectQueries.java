package dev.eventchain.m2t.run;

import dev.eventchain.ocl.evaluation.Evaluation;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.emf.ecore.EcorePackage;
import org.eclipse.emf.ecore.resource.Resource;

/** What the operations on model elements ask of a model. */
public final class ObjectQueries {
  private final Evaluation evaluation;
  private Map<EObject, Set<EObject>> referrers;

  ObjectQueries(Evaluation evaluation) {
    this.evaluation = evaluation;
  }

  /** The objects that refer to an object, containment left out, in the order of the model. */
  public Collection<EObject> referrers(EObject object) {
    if (referrers == null) {
      referrers = new HashMap<>();
      for (EObject each : evaluation.allInstances(EcorePackage.Literals.EOBJECT)) {
        addReferences(each);
      }
    }
    return referrers.getOrDefault(object, Set.of());
  }

  private void addReferences(EObject from) {
    for (EReference reference : from.eClass().getEAllReferences()) {
      boolean crosses =
          !reference.isContainment() && !reference.isContainer() && !reference.isDerived();
      if (crosses && from.eIsSet(reference)) {
        for (Object target : Elements.of(from.eGet(reference))) {
          referrers.computeIfAbsent((EObject) target, key -> new LinkedHashSet<>()).add(from);
        }
      }
    }
  }

  /** All objects that an object contains, at any depth, parents first. */
  public static List<EObject> allContents(EObject object) {
    List<EObject> contents = new ArrayList<>();
    object.eAllContents().forEachRemaining(contents::add);
    return contents;
  }

  /** The containers of an object from the nearest on. */
  public static List<EObject> ancestors(EObject object) {
    List<EObject> ancestors = new ArrayList<>();
    for (EObject each = object.eContainer(); each != null; each = each.eContainer()) {
      ancestors.add(each);
    }
    return ancestors;
  }

  /** All objects that stand next to an object and the object itself, in their order. */
  public static List<EObject> row(EObject object) {
    EObject container = object.eContainer();
    if (container != null) {
      return container.eContents();
    }
    Resource resource = object.eResource();
    return resource == null ? List.of(object) : resource.getContents();
  }
}
