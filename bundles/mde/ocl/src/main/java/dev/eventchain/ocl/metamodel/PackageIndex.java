package dev.eventchain.ocl.metamodel;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.ENamedElement;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EcorePackage;
import org.eclipse.emf.ecore.impl.EPackageImpl;
import org.eclipse.emf.ecore.impl.EPackageRegistryImpl;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.eclipse.ocl.parser.AbstractOCLAnalyzer;

/**
 * The packages that expressions can name, with their subpackages: the given ones, then those that
 * they refer to.
 */
public final class PackageIndex {

  private final Set<EPackage> given = new LinkedHashSet<>();
  private final Set<EPackage> all = new LinkedHashSet<>();

  /** Cache of the classifiers by path, since each parse looks them up again. */
  private final Map<List<String>, List<EClassifier>> classifiers = new ConcurrentHashMap<>();

  private final Map<EClass, List<EClass>> classesBelow = new ConcurrentHashMap<>();

  public PackageIndex(Collection<EPackage> packages) {
    packages.forEach(each -> add(each, given));
    all.addAll(given);
    Deque<EPackage> open = new ArrayDeque<>(given);
    while (!open.isEmpty()) {
      for (EPackage referred : referredBy(open.remove())) {
        Set<EPackage> more = new LinkedHashSet<>();
        add(referred, more);
        more.stream().filter(this::isNew).forEach(open::add);
      }
    }
  }

  private static void add(EPackage each, Set<EPackage> packages) {
    if (packages.add(each)) {
      each.getESubpackages().forEach(nested -> add(nested, packages));
    }
  }

  /** Adds a package, unless there is one of the same namespace; returns whether it was added. */
  private boolean isNew(EPackage referred) {
    String namespace = referred.getNsURI();
    boolean known =
        namespace != null && all.stream().anyMatch(each -> namespace.equals(each.getNsURI()));
    return !known && all.add(referred);
  }

  /** Returns the outermost packages of all types that a metamodel names; no generated packages. */
  private static Set<EPackage> referredBy(EPackage metamodel) {
    Set<EPackage> referred = new LinkedHashSet<>();
    metamodel
        .eAllContents()
        .forEachRemaining(
            element -> {
              for (EObject other : element.eCrossReferences()) {
                if (other instanceof EClassifier
                    && EcoreUtil.getRootContainer(other) instanceof EPackage owner
                    && owner.getClass() == EPackageImpl.class) {
                  referred.add(owner);
                }
              }
            });
    return referred;
  }

  /** Returns the given packages, those that they refer to, and all subpackages. */
  public Set<EPackage> all() {
    return all;
  }

  /**
   * Returns the hint for an unknown type name: the name that was probably meant, or else the known
   * metamodels, of which one may be missing.
   */
  public String hintForType(List<String> path) {
    return new TypeHints(this).of(path);
  }

  /** Returns a hint with the known metamodels and how to add others; empty if there are none. */
  public String hintForMetamodels() {
    return new TypeHints(this).metamodels();
  }

  /** Returns a registry of exactly these packages. */
  public EPackage.Registry registry() {
    EPackage.Registry registry = new EPackageRegistryImpl();
    for (EPackage each : all) {
      if (each.getNsURI() != null) {
        registry.put(each.getNsURI(), each);
      }
    }
    return registry;
  }

  /**
   * Returns the packages whose qualified names end with a path, or only the one whose full name it
   * is. Given packages come before referred ones, and these before Ecore; later ones count only if
   * no earlier one matches.
   */
  public List<EPackage> packages(List<String> path) {
    List<EPackage> found = given.stream().filter(each -> endsWith(each, path)).toList();
    if (found.isEmpty()) {
      found = all.stream().filter(each -> endsWith(each, path)).toList();
    }
    if (found.isEmpty() && endsWith(EcorePackage.eINSTANCE, path)) {
      return List.of(EcorePackage.eINSTANCE);
    }
    List<EPackage> exact = found.stream().filter(each -> depth(each) == path.size()).toList();
    return exact.size() == 1 ? exact : found;
  }

  /** Returns the subclasses of a class, in the order of their packages. */
  public List<EClass> classesBelow(EClass type) {
    return classesBelow.computeIfAbsent(
        type,
        upper ->
            all.stream()
                .flatMap(each -> each.getEClassifiers().stream())
                .filter(EClass.class::isInstance)
                .map(EClass.class::cast)
                .filter(each -> each != upper && upper.isSuperTypeOf(each))
                .toList());
  }

  private static int depth(EPackage innermost) {
    int depth = 0;
    for (EPackage each = innermost; each != null; each = each.getESuperPackage()) {
      depth++;
    }
    return depth;
  }

  /** Returns the qualified name: {@code outer::inner}. */
  public static String qualifiedName(EPackage innermost) {
    EPackage outer = innermost.getESuperPackage();
    return (outer == null ? "" : qualifiedName(outer) + "::") + innermost.getName();
  }

  /**
   * Returns the classifiers of a simple or qualified name, or only the one whose full name it is.
   * Given packages come before referred ones, and these before Ecore; later ones count only if no
   * earlier one matches.
   */
  public List<EClassifier> classifiers(List<String> path) {
    return classifiers.computeIfAbsent(List.copyOf(path), this::find);
  }

  private List<EClassifier> find(List<String> path) {
    List<EClassifier> found = new ArrayList<>();
    given.forEach(each -> addClassifier(each, path, found));
    if (found.isEmpty()) {
      all.forEach(each -> addClassifier(each, path, found));
    }
    if (found.isEmpty()) {
      addClassifier(EcorePackage.eINSTANCE, path, found);
    }
    List<EClassifier> exact =
        found.stream().filter(each -> depth(each.getEPackage()) == path.size() - 1).toList();
    return List.copyOf(exact.size() == 1 ? exact : found);
  }

  /** Returns the classifier at a path from a package; {@code null} if there is none. */
  public static EClassifier classifierIn(EPackage start, List<String> path) {
    EPackage inner = start;
    for (String name : path.subList(0, path.size() - 1)) {
      inner =
          inner == null
              ? null
              : inner.getESubpackages().stream()
                  .filter(each -> isNamed(name, each))
                  .findFirst()
                  .orElse(null);
    }
    List<EClassifier> found = new ArrayList<>();
    if (inner != null) {
      addClassifier(inner, path.subList(path.size() - 1, path.size()), found);
    }
    return found.isEmpty() ? null : found.get(0);
  }

  private static void addClassifier(
      EPackage candidate, List<String> path, List<EClassifier> found) {
    int last = path.size() - 1;
    if (endsWith(candidate, path.subList(0, last))) {
      for (EClassifier classifier : candidate.getEClassifiers()) {
        if (isNamed(path.get(last), classifier)) {
          found.add(classifier);
        }
      }
    }
  }

  private static boolean endsWith(EPackage candidate, List<String> path) {
    EPackage each = candidate;
    for (int i = path.size() - 1; i >= 0; i--) {
      if (each == null || !isNamed(path.get(i), each)) {
        return false;
      }
      each = each.getESuperPackage();
    }
    return true;
  }

  /** Returns whether a name in a text, perhaps escaped as {@code _name}, means an element. */
  private static boolean isNamed(String name, ENamedElement element) {
    return element.getName() != null && AbstractOCLAnalyzer.equalName(name, element.getName());
  }
}
