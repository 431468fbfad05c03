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
 * The packages that expressions can name, with all that are nested in them: those that were given,
 * then those that they refer to.
 */
public final class PackageIndex {

  private final Set<EPackage> given = new LinkedHashSet<>();
  private final Set<EPackage> all = new LinkedHashSet<>();

  /** What was found by each path, which each parse of an expression asks for again. */
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

  /** Adds a package, unless it is there already or is another one of the same namespace. */
  private boolean isNew(EPackage referred) {
    String namespace = referred.getNsURI();
    boolean known =
        namespace != null && all.stream().anyMatch(each -> namespace.equals(each.getNsURI()));
    return !known && all.add(referred);
  }

  /** The outermost packages of all types that a metamodel names; none of those that Java knows. */
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

  /** All packages: those that were given, those that they refer to, and those nested in them. */
  public Set<EPackage> all() {
    return all;
  }

  /**
   * What to do about the name of a type that there is not: the one that was meant, or else the
   * metamodels, of which one may be missing.
   */
  public String hintForType(List<String> path) {
    return new TypeHints(this).of(path);
  }

  /** Which metamodels are known, and how to give others; empty if there are none. */
  public String hintForMetamodels() {
    return new TypeHints(this).metamodels();
  }

  /** A registry of these packages and no others. */
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
   * The packages whose qualified name ends with this path; only the one whose whole name it is, if
   * there is one; those that are only referred to if none is given, and Ecore if there are no
   * others.
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

  /** The classes that have a class above them, in the order of their packages. */
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

  /** {@code outer::inner}. */
  public static String qualifiedName(EPackage innermost) {
    EPackage outer = innermost.getESuperPackage();
    return (outer == null ? "" : qualifiedName(outer) + "::") + innermost.getName();
  }

  /**
   * The classifiers of this simple or qualified name; only the one whose whole name it is, if there
   * is one; those of packages that are only referred to if no given one has any, and those of Ecore
   * if there are no others.
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

  /** The classifier that a path leads to from a package; {@code null} if there is none. */
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

  /** Whether a name in a text, which may be escaped as {@code _name}, means an element. */
  private static boolean isNamed(String name, ENamedElement element) {
    return element.getName() != null && AbstractOCLAnalyzer.equalName(name, element.getName());
  }
}
