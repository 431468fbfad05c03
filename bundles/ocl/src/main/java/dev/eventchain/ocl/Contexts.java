package dev.eventchain.ocl;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.resource.Resource;

/** Finds the metamodels, packages and classes that rule documents name. */
final class Contexts {

  private final PackageIndex packages;
  private final List<Diagnostic> problems;

  Contexts(PackageIndex packages, List<Diagnostic> problems) {
    this.packages = packages;
    this.problems = problems;
  }

  /** Checks that an import names a loaded metamodel: its URI, its file or its package. */
  void check(RuleDocument.Import wanted) {
    String target = wanted.target().replaceFirst("#.*", "");
    boolean known = !packages.packages(List.of(target.split("::", -1))).isEmpty();
    for (EPackage each : packages.all()) {
      Resource resource = each.eResource();
      known |= target.equals(each.getNsURI());
      known |= resource != null && isFileOf(target, resource);
    }
    if (!known) {
      problems.add(
          Diagnostic.error(
                  "ocl.import.unknown",
                  "The import names no loaded metamodel: '" + wanted.target() + "'.",
                  wanted.location())
              .withHint("Loaded: " + String.join(", ", packageNames()) + "."));
    }
  }

  private static boolean isFileOf(String target, Resource resource) {
    String file = target.substring(target.lastIndexOf('/') + 1);
    return resource.getURI() != null
        && !file.isEmpty()
        && file.equals(resource.getURI().lastSegment());
  }

  private Set<String> packageNames() {
    Set<String> result = new TreeSet<>();
    packages.all().forEach(each -> result.add(each.getName()));
    return result;
  }

  /** The class that a clause is about; a problem if there is not exactly one of its name. */
  Optional<ResolvedClause> resolve(RuleDocument.Clause clause) {
    EPackage given = null;
    if (clause.packagePath() != null) {
      List<EPackage> found = packages.packages(clause.packagePath().names());
      if (found.size() != 1) {
        problems.add(packageProblem(clause.packagePath(), found));
        return Optional.empty();
      }
      given = found.get(0);
    }
    EPackage first = given;
    return contextClass(clause.context(), first)
        .map(
            context ->
                new ResolvedClause(clause, context, first == null ? context.getEPackage() : first));
  }

  private Diagnostic packageProblem(RuleDocument.Path path, List<EPackage> found) {
    String last = path.names().get(path.names().size() - 1);
    String candidates = String.join(", ", found.stream().map(PackageIndex::qualifiedName).toList());
    return found.isEmpty()
        ? Diagnostic.error("ocl.type", "There is no package '" + path + "'.", path.location())
            .withHint(NearestName.question(last, packageNames()))
        : Diagnostic.error(
                "ocl.type", "Several packages are called '" + path + "'.", path.location())
            .withHint("Write one of " + candidates + ".");
  }

  private Optional<EClass> contextClass(RuleDocument.Path path, EPackage contextPackage) {
    List<EClassifier> found = new ArrayList<>();
    for (EPackage each = contextPackage; each != null; each = each.getESuperPackage()) {
      EClassifier local = each.getEClassifier(path.toString());
      if (local != null && found.isEmpty()) {
        found.add(local);
      }
    }
    if (found.isEmpty()) {
      found.addAll(packages.classifiers(path.names()));
    }
    if (found.size() == 1 && found.get(0) instanceof EClass context) {
      return Optional.of(context);
    }
    problems.add(contextProblem(path, found));
    return Optional.empty();
  }

  private Diagnostic contextProblem(RuleDocument.Path path, List<EClassifier> found) {
    if (found.isEmpty()) {
      Set<String> classes = new LinkedHashSet<>();
      for (EPackage each : packages.all()) {
        each.getEClassifiers().forEach(classifier -> classes.add(classifier.getName()));
      }
      String last = path.names().get(path.names().size() - 1);
      return Diagnostic.error("ocl.type", "There is no class '" + path + "'.", path.location())
          .withHint(NearestName.question(last, classes));
    } else if (found.size() == 1) {
      return Diagnostic.error("ocl.type", "'" + path + "' is not a class.", path.location());
    }
    List<String> candidates = found.stream().map(Names::qualified).toList();
    return Diagnostic.error(
            "ocl.type", "Several classes are called '" + path + "'.", path.location())
        .withHint("Write one of " + String.join(", ", candidates) + ".");
  }
}
