package dev.eventchain.ocl;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.ENamedElement;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EcorePackage;
import org.eclipse.emf.ecore.impl.EPackageRegistryImpl;
import org.eclipse.ocl.parser.AbstractOCLAnalyzer;

/** The packages that expressions can name, with all that are nested in them. */
final class PackageIndex {

  private final Set<EPackage> packages = new LinkedHashSet<>();

  /** What was found by each path, which each parse of an expression asks for again. */
  private final Map<List<String>, List<EClassifier>> classifiers = new ConcurrentHashMap<>();

  private final Map<EClass, List<EClass>> classesBelow = new ConcurrentHashMap<>();

  PackageIndex(Collection<EPackage> given) {
    given.forEach(this::add);
  }

  private void add(EPackage each) {
    if (packages.add(each)) {
      each.getESubpackages().forEach(this::add);
    }
  }

  /** All packages, those that were given and those nested in them. */
  Set<EPackage> all() {
    return packages;
  }

  /** A registry of these packages and no others. */
  EPackage.Registry registry() {
    EPackage.Registry registry = new EPackageRegistryImpl();
    for (EPackage each : packages) {
      if (each.getNsURI() != null) {
        registry.put(each.getNsURI(), each);
      }
    }
    return registry;
  }

  /**
   * The packages whose qualified name ends with this path; only the one whose whole name it is, if
   * there is one; Ecore only if there are no others.
   */
  List<EPackage> packages(List<String> path) {
    List<EPackage> found = new ArrayList<>();
    for (EPackage each : packages) {
      if (endsWith(each, path)) {
        found.add(each);
      }
    }
    if (found.isEmpty() && endsWith(EcorePackage.eINSTANCE, path)) {
      return List.of(EcorePackage.eINSTANCE);
    }
    List<EPackage> exact = found.stream().filter(each -> depth(each) == path.size()).toList();
    return exact.size() == 1 ? exact : found;
  }

  /** The classes that have a class above them, in the order of their packages. */
  List<EClass> classesBelow(EClass type) {
    return classesBelow.computeIfAbsent(
        type,
        upper ->
            packages.stream()
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
  static String qualifiedName(EPackage innermost) {
    EPackage outer = innermost.getESuperPackage();
    return (outer == null ? "" : qualifiedName(outer) + "::") + innermost.getName();
  }

  /**
   * The classifiers of this simple or qualified name; only the one whose whole name it is, if there
   * is one; those of Ecore only if there are no others.
   */
  List<EClassifier> classifiers(List<String> path) {
    return classifiers.computeIfAbsent(List.copyOf(path), this::find);
  }

  private List<EClassifier> find(List<String> path) {
    List<EClassifier> found = new ArrayList<>();
    for (EPackage each : packages) {
      addClassifier(each, path, found);
    }
    if (found.isEmpty()) {
      addClassifier(EcorePackage.eINSTANCE, path, found);
    }
    List<EClassifier> exact =
        found.stream().filter(each -> depth(each.getEPackage()) == path.size() - 1).toList();
    return List.copyOf(exact.size() == 1 ? exact : found);
  }

  /** The classifier that a path leads to from a package; {@code null} if there is none. */
  static EClassifier classifierIn(EPackage start, List<String> path) {
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
