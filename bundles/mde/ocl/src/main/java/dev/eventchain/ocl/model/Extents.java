package dev.eventchain.ocl.model;

import dev.eventchain.ocl.values.InsertionOrderedSet;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.resource.Resource;
import org.eclipse.emf.ecore.util.EcoreUtil;

/**
 * The instances of each class: those of the whole resource set of a model, in the order of its
 * resources and then of containment. Computed on first use and cached. Thread-safe as long as the
 * model does not change.
 */
public final class Extents {

  private final List<EObject> roots;

  private final Map<EClass, Set<EObject>> instances = new ConcurrentHashMap<>();
  private ModelContents below;
  private ModelContents model;

  public Extents(Collection<? extends EObject> roots) {
    this.roots = List.copyOf(roots);
  }

  /** Returns the contents of the roots, which may be less than the whole model. */
  public synchronized ModelContents below() {
    if (below == null) {
      below = ModelContents.below(roots);
    }
    return below;
  }

  /** Returns all instances of a class. */
  public Set<EObject> get(EClass type) {
    Set<EObject> extent = instances.get(type);
    return extent != null ? extent : instances.computeIfAbsent(type, this::findInstances);
  }

  private Set<EObject> findInstances(EClass type) {
    return InsertionOrderedSet.ofDistinct(model().instancesOf(type));
  }

  private synchronized ModelContents model() {
    if (model == null) {
      Map<EObject, ModelContents> parts = new LinkedHashMap<>();
      for (EObject object : roots) {
        EObject root = EcoreUtil.getRootContainer(object);
        if (!parts.containsKey(root)) {
          addModelOf(root, parts);
        }
      }
      model = ModelContents.union(new LinkedHashSet<>(parts.values()));
    }
    return model;
  }

  private void addModelOf(EObject root, Map<EObject, ModelContents> parts) {
    Resource resource = root.eResource();
    if (resource == null || resource.getResourceSet() == null) {
      addTrees(resource == null ? List.of(root) : resource.getContents(), parts);
      return;
    }
    List<Resource> resources = resource.getResourceSet().getResources();
    // By index: walking a resource may load another one that it refers to.
    for (int i = 0; i < resources.size(); i++) {
      List<EObject> contents = resources.get(i).getContents();
      boolean metamodel = !contents.isEmpty() && contents.get(0) instanceof EPackage;
      if (!metamodel || root instanceof EPackage) {
        addTrees(contents, parts);
      }
    }
  }

  private void addTrees(List<EObject> trees, Map<EObject, ModelContents> parts) {
    ModelContents part = roots.equals(trees) ? below() : ModelContents.below(trees);
    part.roots().forEach(root -> parts.putIfAbsent(root, part));
  }
}
