package dev.eventchain.ocl;

import java.util.AbstractMap;
import java.util.ArrayList;
import java.util.Collection;
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
 *
 * <p>It is the map that Eclipse OCL asks for; only {@link #get} is used.
 */
final class Extents extends AbstractMap<EClass, Set<EObject>> {

  private final List<EObject> roots;
  private final Map<EClass, Set<EObject>> instances = new ConcurrentHashMap<>();
  private List<EObject> all;

  Extents(Collection<? extends EObject> roots) {
    this.roots = List.copyOf(roots);
  }

  @Override
  public Set<EObject> get(Object type) {
    return type instanceof EClass eClass
        ? instances.computeIfAbsent(eClass, this::findInstances)
        : Set.of();
  }

  private Set<EObject> findInstances(EClass type) {
    Set<EObject> found = new InsertionOrderedSet<>();
    for (EObject object : all()) {
      if (type.isInstance(object)) {
        found.add(object);
      }
    }
    return found;
  }

  private synchronized List<EObject> all() {
    if (all == null) {
      Set<EObject> found = new LinkedHashSet<>();
      for (EObject root : roots) {
        addModelOf(root, found);
      }
      all = new ArrayList<>(found);
    }
    return all;
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

  @Override
  public Set<Entry<EClass, Set<EObject>>> entrySet() {
    throw new UnsupportedOperationException("extents are found when asked for");
  }
}
