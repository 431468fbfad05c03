package dev.eventchain.rules;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.eclipse.emf.common.util.TreeIterator;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EDataType;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.util.EcoreUtil;

/** The elements of a model by their classes, each in the order of the model. */
final class ModelElements {

  private final List<EObject> all = new ArrayList<>();
  private final Map<EClass, List<Integer>> byClass = new LinkedHashMap<>();
  private final Map<EClass, List<EObject>> instances = new HashMap<>();
  private final Map<EDataType, List<HeldValue>> values = new HashMap<>();

  /** All elements below some roots, the roots included, each once. */
  ModelElements(Collection<? extends EObject> roots) {
    Set<EObject> seen = mayOverlap(roots) ? new HashSet<>() : null;
    TreeIterator<EObject> objects = EcoreUtil.getAllContents(roots, true);
    while (objects.hasNext()) {
      EObject object = objects.next();
      if (seen == null || seen.add(object)) {
        byClass.computeIfAbsent(object.eClass(), none -> new ArrayList<>()).add(all.size());
        all.add(object);
      }
    }
  }

  /** Whether a root may be found again below another one. */
  private static boolean mayOverlap(Collection<? extends EObject> roots) {
    return roots.stream().anyMatch(root -> root.eContainer() != null)
        || new HashSet<>(roots).size() < roots.size();
  }

  int size() {
    return all.size();
  }

  /** What constraints of a class or a data type are about: its instances, or its values. */
  List<?> subjectsOf(EClassifier type) {
    return type instanceof EClass objects ? instancesOf(objects) : valuesOf((EDataType) type);
  }

  private List<HeldValue> valuesOf(EDataType type) {
    return values.computeIfAbsent(type, wanted -> HeldValue.of(wanted, all));
  }

  /** The instances of a class and its subclasses. */
  List<EObject> instancesOf(EClass type) {
    return instances.computeIfAbsent(type, this::find);
  }

  private List<EObject> find(EClass type) {
    List<List<Integer>> matching = new ArrayList<>();
    for (List<Integer> indices : byClass.values()) {
      if (type.isInstance(all.get(indices.get(0)))) {
        matching.add(indices);
      }
    }
    int[] indices = matching.stream().flatMap(List::stream).mapToInt(Integer::intValue).toArray();
    Arrays.sort(indices);
    return Arrays.stream(indices).mapToObj(all::get).toList();
  }
}
