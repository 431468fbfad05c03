package dev.eventchain.constraints;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.eclipse.emf.common.util.TreeIterator;
import org.eclipse.emf.common.util.URI;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.resource.Resource;
import org.eclipse.emf.ecore.resource.impl.ResourceImpl;
import org.eclipse.emf.ecore.util.EcoreUtil;

/** A copy of a model whose objects are identified by position. */
final class ModelCopy {
  private final List<EObject> roots;
  private final List<EObject> objects = new ArrayList<>();

  private ModelCopy(List<EObject> roots) {
    this.roots = List.copyOf(roots);
    Resource resource = new ResourceImpl(URI.createURI("changed"));
    resource.getContents().addAll(this.roots);
    TreeIterator<EObject> all = resource.getAllContents();
    while (all.hasNext()) {
      objects.add(all.next());
    }
  }

  /** Returns a copy of some roots. */
  static ModelCopy of(List<EObject> roots) {
    return new ModelCopy(List.copyOf(EcoreUtil.copyAll(roots)));
  }

  /** Returns a copy with a change. */
  ModelCopy with(ModelChange change) {
    return with(change::apply);
  }

  /** Returns a copy with changes, which are made in it. */
  ModelCopy with(Consumer<ModelCopy> changes) {
    ModelCopy copy = of(roots);
    changes.accept(copy);
    return new ModelCopy(copy.roots);
  }

  List<EObject> objects() {
    return objects;
  }

  List<EObject> instancesOf(EClass type) {
    return objects.stream().filter(type::isInstance).toList();
  }
}
