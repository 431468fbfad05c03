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

/** Model queries of the operations on model elements. */
public final class ObjectQueries {
  private final Evaluation evaluation;
  private Map<EObject, Set<EObject>> referrers;

  ObjectQueries(Evaluation evaluation) {
    this.evaluation = evaluation;
  }

  /**
   * Returns the objects that refer to an object, without containment, in the order of the model.
   */
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

  /** Returns all direct and indirect contents of an object, parents first. */
  public static List<EObject> allContents(EObject object) {
    List<EObject> contents = new ArrayList<>();
    object.eAllContents().forEachRemaining(contents::add);
    return contents;
  }

  /** Returns the containers of an object, nearest first. */
  public static List<EObject> ancestors(EObject object) {
    List<EObject> ancestors = new ArrayList<>();
    for (EObject each = object.eContainer(); each != null; each = each.eContainer()) {
      ancestors.add(each);
    }
    return ancestors;
  }

  /** Returns an object and its siblings, in their order. */
  public static List<EObject> row(EObject object) {
    EObject container = object.eContainer();
    if (container != null) {
      return container.eContents();
    }
    Resource resource = object.eResource();
    return resource == null ? List.of(object) : resource.getContents();
  }
}
