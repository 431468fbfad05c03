package dev.eventchain.ocl.metamodel;

import dev.eventchain.diagnostics.NearestName;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EPackage;

/** Hints for type names that are in no metamodel. */
public final class TypeHints {

  private static final int MOST_NAMES_LISTED = 8;
  private static final List<String> PREDEFINED = List.of("String", "Integer", "Real", "Boolean");

  private final PackageIndex packages;

  public TypeHints(PackageIndex packages) {
    this.packages = packages;
  }

  /** Returns the names of all types, without their packages. */
  public Set<String> names() {
    Set<String> names = new LinkedHashSet<>();
    for (EPackage each : packages.all()) {
      each.getEClassifiers().forEach(classifier -> names.add(classifier.getName()));
    }
    names.addAll(PREDEFINED);
    return names;
  }

  /**
   * Suggests the nearest type; if none is near, names the metamodels, of which one may be missing.
   */
  public String of(List<String> path) {
    String nearest = nearest(path);
    return nearest.isEmpty() ? metamodels() : nearest;
  }

  private String nearest(List<String> path) {
    String last = path.get(path.size() - 1);
    if (path.size() == 1) {
      return NearestName.question(last, names());
    }
    List<EClassifier> elsewhere = packages.classifiers(List.of(last));
    if (!elsewhere.isEmpty()) {
      return "Did you mean `" + Names.qualified(elsewhere.get(0)) + "`?";
    }
    List<String> qualifier = path.subList(0, path.size() - 1);
    List<String> types =
        packages.packages(qualifier).stream()
            .flatMap(each -> each.getEClassifiers().stream())
            .map(EClassifier::getName)
            .toList();
    Optional<String> inside = NearestName.of(last, types);
    return inside.isPresent()
        ? "Did you mean `" + String.join("::", qualifier) + "::" + inside.get() + "`?"
        : NearestName.question(path.get(0), names());
  }

  /** Returns a hint with the known metamodels and how to add others. */
  public String metamodels() {
    Collection<EPackage> all = packages.all();
    Stream<EPackage> outermost =
        all.stream().filter(each -> !all.contains(each.getESuperPackage()));
    List<String> names = outermost.map(each -> "`" + each.getName() + "`").distinct().toList();
    if (names.isEmpty()) {
      return "";
    }
    return "Known "
        + (names.size() == 1 ? "is the metamodel " : "are the metamodels ")
        + names.stream().limit(MOST_NAMES_LISTED).collect(Collectors.joining(", "))
        + (names.size() > MOST_NAMES_LISTED ? ", ..." : "")
        + "; name another one with --metamodel FILE.ecore.";
  }
}
