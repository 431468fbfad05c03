package dev.eventchain.constraints.document;

import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.ocl.metamodel.Names;
import dev.eventchain.ocl.metamodel.PackageIndex;
import dev.eventchain.ocl.text.ExpressionRules;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.ETypedElement;
import org.eclipse.emf.ecore.EcorePackage;
import org.eclipse.emf.ecore.resource.Resource;

/** Finds the metamodels, packages and classes that rule documents name. */
public final class Contexts {

  /** URI of the standard library in Eclipse OCL, which is always available. */
  private static final String STANDARD_LIBRARY = "http://www.eclipse.org/ocl/";

  private final PackageIndex packages;
  private final List<Diagnostic> problems;

  public Contexts(PackageIndex packages, List<Diagnostic> problems) {
    this.packages = packages;
    this.problems = problems;
  }

  /**
   * Checks that an import names a loaded metamodel, by its URI, its file or its package, one of the
   * documents, or the standard library.
   */
  public void check(DocumentImports.Import wanted, List<String> documents) {
    String target = wanted.target().replaceFirst("#.*", "");
    boolean known =
        target.equals(EcorePackage.eNS_URI)
            || (target.startsWith(STANDARD_LIBRARY) && !DocumentImports.isDocument(target))
            || DocumentImports.names(wanted, documents)
            || !packages.packages(List.of(target.split("::", -1))).isEmpty();
    for (EPackage each : packages.all()) {
      Resource resource = each.eResource();
      known |= target.equals(each.getNsURI());
      known |= resource != null && isFileOf(target, resource);
    }
    if (!known) {
      problems.add(
          Diagnostic.of(
                  ConstraintRules.IMPORT_UNKNOWN,
                  "The import names neither a loaded metamodel nor a rules document: '"
                      + wanted.target()
                      + "'.",
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

  /**
   * Finds the class or data type of a clause; reports a problem unless exactly one has its name.
   */
  public Optional<ResolvedClause> resolve(RuleDocument.Clause clause) {
    return classifierOf(clause.packagePath(), clause.context())
        .map(
            context ->
                new ResolvedClause(
                    clause,
                    context,
                    contextPackage(clause.packagePath()).orElse(context.getEPackage())));
  }

  /** Finds the operation or feature that a context names; reports it if its class has none. */
  public Optional<ETypedElement> resolve(MemberContext member) {
    Optional<EClass> owner =
        classifierOf(member.packagePath(), member.owner())
            .filter(found -> isClass(found, member.owner()))
            .map(EClass.class::cast);
    Optional<ETypedElement> found = owner.flatMap(type -> memberOf(type, member));
    if (owner.isPresent() && found.isEmpty()) {
      String wanted =
          member.parameters() == null
              ? "feature '" + member.name() + "'"
              : "operation '"
                  + member.name()
                  + "' with "
                  + Coverage.counted(member.parameters().size(), "parameter");
      List<String> known =
          owner.get().eContents().stream()
              .filter(ETypedElement.class::isInstance)
              .map(each -> ((ETypedElement) each).getName())
              .toList();
      problems.add(
          Diagnostic.of(
                  ExpressionRules.TYPE,
                  Names.of(owner.get()) + " has no " + wanted + " of its own.",
                  member.owner().location())
              .withHint(NearestName.question(member.name(), known)));
    }
    return found;
  }

  private boolean isClass(EClassifier type, RuleDocument.Path path) {
    if (type instanceof EClass) {
      return true;
    }
    problems.add(
        Diagnostic.of(ExpressionRules.TYPE, "'" + path + "' is not a class.", path.location()));
    return false;
  }

  private static Optional<ETypedElement> memberOf(EClass type, MemberContext member) {
    return Stream.concat(type.getEOperations().stream(), type.getEStructuralFeatures().stream())
        .filter(each -> member.name().equals(each.getName()))
        .filter(
            each ->
                each instanceof EOperation operation
                    ? member.parameters() != null
                        && operation.getEParameters().size() == member.parameters().size()
                    : member.parameters() == null)
        .map(ETypedElement.class::cast)
        .findFirst();
  }

  private Optional<EPackage> contextPackage(RuleDocument.Path path) {
    return path == null ? Optional.empty() : packages.packages(path.names()).stream().findFirst();
  }

  private Optional<EClassifier> classifierOf(
      RuleDocument.Path packagePath, RuleDocument.Path path) {
    if (packagePath != null) {
      List<EPackage> found = packages.packages(packagePath.names());
      if (found.size() != 1) {
        problems.add(packageProblem(packagePath, found));
        return Optional.empty();
      }
    }
    return contextClassifier(path, contextPackage(packagePath).orElse(null));
  }

  private Diagnostic packageProblem(RuleDocument.Path path, List<EPackage> found) {
    String last = path.names().get(path.names().size() - 1);
    String near = NearestName.question(last, packageNames());
    String candidates = String.join(", ", found.stream().map(PackageIndex::qualifiedName).toList());
    return found.isEmpty()
        ? Diagnostic.of(
                ExpressionRules.TYPE, "There is no package '" + path + "'.", path.location())
            .withHint(near.isEmpty() ? packages.hintForMetamodels() : near)
        : Diagnostic.of(
                ExpressionRules.TYPE,
                "Several packages are called '" + path + "'.",
                path.location())
            .withHint("Write one of " + candidates + ".");
  }

  private Optional<EClassifier> contextClassifier(RuleDocument.Path path, EPackage contextPackage) {
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
    if (found.size() == 1) {
      return Optional.of(found.get(0));
    }
    problems.add(contextProblem(path, found));
    return Optional.empty();
  }

  private Diagnostic contextProblem(RuleDocument.Path path, List<EClassifier> found) {
    if (found.isEmpty()) {
      return Diagnostic.of(
              ExpressionRules.TYPE,
              "No known metamodel has a class '" + path + "'.",
              path.location())
          .withHint(packages.hintForType(path.names()));
    }
    List<String> candidates = found.stream().map(Names::qualified).toList();
    return Diagnostic.of(
            ExpressionRules.TYPE, "Several classes are called '" + path + "'.", path.location())
        .withHint("Write one of " + String.join(", ", candidates) + ".");
  }
}
