package dev.eventchain.ocl;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.eclipse.emf.common.util.TreeIterator;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.resource.Resource;
import org.eclipse.emf.ecore.util.EcoreUtil;

/**
 * The instances of each class: those of the whole resource set of a model, in the order of its
 * resources and then of containment. Found when first asked for and kept. Safe for threads, as long
 * as the model does not change.
 */
final class Extents {

  /** Objects that are instances of the same classes, as far as Java is concerned, too. */
  private record Likeness(EClass type, Class<?> implementation) {
    static Likeness of(EObject object) {
      return new Likeness(object.eClass(), object.getClass());
    }
  }

  /** All objects, and the same once more, sorted by what they are alike in. */
  private record Model(List<EObject> all, Map<Likeness, List<EObject>> alike) {}

  private final List<EObject> roots;
  private final Map<EClass, Set<EObject>> instances = new ConcurrentHashMap<>();
  private Model model;

  Extents(Collection<? extends EObject> roots) {
    this.roots = List.copyOf(roots);
  }

  /** All instances of a class. */
  Set<EObject> get(EClass type) {
    Set<EObject> known = instances.get(type);
    return known != null ? known : instances.computeIfAbsent(type, this::findInstances);
  }

  private Set<EObject> findInstances(EClass type) {
    Model found = model();
    Map<Likeness, List<EObject>> fitting = new LinkedHashMap<>();
    found
        .alike()
        .forEach(
            (likeness, objects) -> {
              if (type.isInstance(objects.get(0))) {
                fitting.put(likeness, objects);
              }
            });
    if (fitting.size() == 1) {
      return InsertionOrderedSet.ofDistinct(fitting.values().iterator().next());
    }
    List<EObject> several = new ArrayList<>();
    if (!fitting.isEmpty()) {
      for (EObject object : found.all()) {
        if (fitting.containsKey(Likeness.of(object))) {
          several.add(object);
        }
      }
    }
    return InsertionOrderedSet.ofDistinct(several);
  }

  private synchronized Model model() {
    if (model == null) {
      Set<EObject> found = new LinkedHashSet<>();
      for (EObject root : roots) {
        addModelOf(root, found);
      }
      Map<Likeness, List<EObject>> alike = new LinkedHashMap<>();
      for (EObject object : found) {
        alike.computeIfAbsent(Likeness.of(object), any -> new ArrayList<>()).add(object);
      }
      model = new Model(new ArrayList<>(found), alike);
    }
    return model;
  }

  private static void addModelOf(EObject object, Set<EObject> found) {
    EObject root = EcoreUtil.getRootContainer(object);
    if (found.contains(root)) {
      return;
    }
    Resource resource = root.eResource();
    if (resource == null || resource.getResourceSet() == null) {
      addTrees(resource == null ? List.of(root) : resource.getContents(), found);
      return;
    }
    List<Resource> resources = resource.getResourceSet().getResources();
    // By index: walking a resource may load another one that it refers to.
    for (int i = 0; i < resources.size(); i++) {
      List<EObject> contents = resources.get(i).getContents();
      boolean metamodel = !contents.isEmpty() && contents.get(0) instanceof EPackage;
      if (!metamodel || root instanceof EPackage) {
        addTrees(contents, found);
      }
    }
  }

  private static void addTrees(List<EObject> roots, Set<EObject> found) {
    TreeIterator<EObject> objects = EcoreUtil.getAllContents(roots, true);
    while (objects.hasNext()) {
      found.add(objects.next());
    }
  }
}
