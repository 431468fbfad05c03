package dev.eventchain.ocl.model;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.emf.ecore.impl.DynamicEObjectImpl;
import org.eclipse.emf.ecore.util.FeatureMapUtil;

/** The elements of a model in the order of containment, and by class. A snapshot; thread-safe. */
public final class ModelContents {

  /** A key of elements that are instances of the same classes, also in Java. */
  private record Likeness(EClass type, Class<?> implementation) {
    static Likeness of(EObject element) {
      return new Likeness(element.eClass(), element.getClass());
    }

    boolean fits(EObject element) {
      return type == element.eClass() && implementation == element.getClass();
    }
  }

  private final List<EObject> roots;
  private final List<EObject> all = new ArrayList<>();
  private final Map<Likeness, List<EObject>> alike = new LinkedHashMap<>();

  /** The key of the latest element, which the next one probably has, too. */
  private Likeness latest;

  private List<EObject> likeLatest;

  private final Map<EClass, Optional<List<EReference>>> plans = new HashMap<>();

  private ModelContents(Collection<? extends EObject> roots) {
    this.roots = List.copyOf(roots);
  }

  /** Returns the roots and all elements below them, each once. */
  static ModelContents below(Collection<? extends EObject> roots) {
    ModelContents contents = new ModelContents(roots);
    Set<EObject> seen = mayOverlap(roots) ? new HashSet<>() : null;
    contents.roots.forEach(root -> contents.addTree(root, seen));
    return contents;
  }

  /** Returns all elements of several models, each once. */
  static ModelContents union(Set<ModelContents> parts) {
    if (parts.size() == 1) {
      return parts.iterator().next();
    }
    Set<EObject> elements = new LinkedHashSet<>();
    parts.forEach(part -> elements.addAll(part.all));
    ModelContents contents =
        new ModelContents(parts.stream().flatMap(part -> part.roots.stream()).toList());
    elements.forEach(contents::add);
    return contents;
  }

  /** Returns whether a root may be contained in another one. */
  private static boolean mayOverlap(Collection<? extends EObject> roots) {
    return roots.stream().anyMatch(root -> root.eContainer() != null)
        || new HashSet<>(roots).size() < roots.size();
  }

  private void addTree(EObject root, Set<EObject> seen) {
    Deque<Iterator<EObject>> open = new ArrayDeque<>();
    open.push(List.of(root).iterator());
    while (!open.isEmpty()) {
      if (!open.peek().hasNext()) {
        open.pop();
        continue;
      }
      EObject element = open.peek().next();
      if (seen == null || seen.add(element)) {
        add(element);
      }
      descend(element, open);
    }
  }

  /** Visits children next, without the list of them that an element keeps once it made one. */
  private void descend(EObject element, Deque<Iterator<EObject>> open) {
    Optional<List<EReference>> containments =
        element instanceof DynamicEObjectImpl
            ? plans.computeIfAbsent(element.eClass(), ModelContents::containmentsOf)
            : Optional.empty();
    if (containments.isEmpty()) {
      open.push(element.eContents().iterator());
      return;
    }
    for (EReference containment : containments.get()) {
      if (element.eIsSet(containment)) {
        open.push(childrenIn(element.eGet(containment)));
      }
    }
  }

  @SuppressWarnings("unchecked") // EMF's lists have no type arguments
  private static Iterator<EObject> childrenIn(Object value) {
    List<?> children = value instanceof List<?> list ? list : List.of(value);
    return ((List<EObject>) children).iterator();
  }

  /** Returns the containments of a class, from last to first; empty if feature maps contain. */
  private static Optional<List<EReference>> containmentsOf(EClass type) {
    if (type.getEAllAttributes().stream().anyMatch(FeatureMapUtil::isFeatureMap)) {
      return Optional.empty();
    }
    List<EReference> stored = new ArrayList<>();
    for (EReference containment : type.getEAllContainments()) {
      if (!containment.isDerived()) {
        stored.add(0, containment);
      }
    }
    return Optional.of(stored);
  }

  private void add(EObject element) {
    if (latest == null || !latest.fits(element)) {
      latest = Likeness.of(element);
      likeLatest = alike.computeIfAbsent(latest, any -> new ArrayList<>());
    }
    likeLatest.add(element);
    all.add(element);
  }

  /** Returns the roots in the order given. */
  List<EObject> roots() {
    return roots;
  }

  /** Returns all elements. */
  public List<EObject> all() {
    return Collections.unmodifiableList(all);
  }

  /** Returns the instances of a class and its subclasses. */
  public List<EObject> instancesOf(EClass type) {
    Map<Likeness, List<EObject>> fitting = new LinkedHashMap<>(alike);
    fitting.values().removeIf(elements -> !type.isInstance(elements.get(0)));
    if (fitting.size() == 1) {
      return Collections.unmodifiableList(fitting.values().iterator().next());
    } else if (fitting.size() == alike.size()) {
      return all();
    }
    return fitting.isEmpty()
        ? List.of()
        : all.stream().filter(element -> fitting.containsKey(Likeness.of(element))).toList();
  }
}
