package dev.eventchain.ocl;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.resource.Resource;

/** Parses rule documents: first all definitions, then the invariants, which may use any of them. */
final class RuleParser {

  /** A clause and what its names mean. */
  private record Resolved(
      SourceText source, RuleDocument.Clause clause, EClass context, EPackage contextPackage) {

    Scope scope() {
      return Scope.EMPTY.with("self", context);
    }

    SourceLocation location() {
      return source.at(clause.keyword());
    }

    /** The expression, whatever its white space and comments. */
    String words() {
      Tokens tokens = new Tokens(source.text().substring(clause.start(), clause.end()));
      StringBuilder words = new StringBuilder();
      for (int i = 0; i < tokens.size(); i++) {
        words.append(tokens.text(i)).append(' ');
      }
      return words.toString();
    }
  }

  private final ExpressionLanguage language;
  private final List<Diagnostic> problems = new ArrayList<>();
  private final List<OclConstraint> constraints = new ArrayList<>();
  private final Map<String, Resolved> names = new HashMap<>();
  private final Map<EClass, Integer> unnamed = new HashMap<>();

  RuleParser(ExpressionLanguage language) {
    this.language = language;
  }

  OclRules parse(List<SourceText> documents) {
    List<Resolved> definitions = new ArrayList<>();
    List<Resolved> invariants = new ArrayList<>();
    for (SourceText document : documents) {
      List<Diagnostic> documentProblems = new ArrayList<>();
      RuleDocument parsed = RuleDocument.read(document, documentProblems);
      problems.addAll(documentProblems);
      parsed.imports().forEach(each -> check(each, document));
      for (RuleDocument.Clause clause : parsed.clauses()) {
        resolve(document, clause)
            .ifPresent(r -> (clause.definition() ? definitions : invariants).add(r));
      }
    }
    define(definitions);
    invariants.forEach(this::addInvariant);
    return new OclRules(constraints, List.copyOf(new TreeSet<>(problems)));
  }

  private void check(RuleDocument.Import wanted, SourceText source) {
    String target = wanted.target().replaceFirst("#.*", "");
    List<String> path = List.of(target.split("::", -1));
    boolean known = !language.packages().packages(path).isEmpty();
    for (EPackage each : language.packages().all()) {
      Resource resource = each.eResource();
      known |= target.equals(each.getNsURI());
      known |= resource != null && isFileOf(target, resource);
    }
    if (!known) {
      problems.add(
          Diagnostic.error(
                  "ocl.import.unknown",
                  "The import names no loaded metamodel: '" + wanted.target() + "'.",
                  source.at(wanted.offset()))
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
    language.packages().all().forEach(each -> result.add(each.getName()));
    return result;
  }

  private Optional<Resolved> resolve(SourceText source, RuleDocument.Clause clause) {
    EPackage contextPackage = null;
    if (clause.packagePath() != null) {
      List<EPackage> found = language.packages().packages(clause.packagePath().names());
      if (found.size() != 1) {
        problems.add(packageProblem(clause.packagePath(), found, source));
        return Optional.empty();
      }
      contextPackage = found.get(0);
    }
    return contextClass(clause.context(), contextPackage, source)
        .map(context -> new Resolved(source, clause, context, packageOf(clause, context)));
  }

  /** Simple names mean the types of the package clause first, or else of the context's package. */
  private EPackage packageOf(RuleDocument.Clause clause, EClass context) {
    return clause.packagePath() == null
        ? context.getEPackage()
        : language.packages().packages(clause.packagePath().names()).get(0);
  }

  private Diagnostic packageProblem(
      RuleDocument.Path path, List<EPackage> found, SourceText source) {
    String message =
        found.isEmpty()
            ? "There is no package '" + path + "'."
            : "Several packages are called '" + path + "'.";
    String last = path.names().get(path.names().size() - 1);
    return Diagnostic.error("ocl.type", message, source.at(path.offset()))
        .withHint(found.isEmpty() ? NearestName.question(last, packageNames()) : "Qualify it.");
  }

  private Optional<EClass> contextClass(
      RuleDocument.Path path, EPackage contextPackage, SourceText source) {
    List<EClassifier> found = new ArrayList<>();
    for (EPackage each = contextPackage; each != null; each = each.getESuperPackage()) {
      EClassifier local = each.getEClassifier(path.toString());
      if (local != null && found.isEmpty()) {
        found.add(local);
      }
    }
    if (found.isEmpty()) {
      found.addAll(language.packages().classifiers(path.names()));
    }
    if (found.size() == 1 && found.get(0) instanceof EClass context) {
      return Optional.of(context);
    }
    problems.add(contextProblem(path, found, source));
    return Optional.empty();
  }

  private Diagnostic contextProblem(
      RuleDocument.Path path, List<EClassifier> found, SourceText source) {
    SourceLocation location = source.at(path.offset());
    if (found.isEmpty()) {
      Set<String> classes = new LinkedHashSet<>();
      for (EPackage each : language.packages().all()) {
        each.getEClassifiers().forEach(classifier -> classes.add(classifier.getName()));
      }
      String last = path.names().get(path.names().size() - 1);
      return Diagnostic.error("ocl.type", "There is no class '" + path + "'.", location)
          .withHint(NearestName.question(last, classes));
    } else if (found.size() == 1) {
      return Diagnostic.error("ocl.type", "'" + path + "' is not a class.", location);
    }
    List<String> candidates = found.stream().map(Names::qualified).toList();
    return Diagnostic.error("ocl.type", "Several classes are called '" + path + "'.", location)
        .withHint("Write one of " + String.join(", ", candidates) + ".");
  }

  /** A definition may use another one that comes later, so those that fail are tried again. */
  private void define(List<Resolved> definitions) {
    List<Resolved> open = definitions;
    List<Diagnostic> errors = new ArrayList<>();
    int before;
    do {
      before = open.size();
      errors.clear();
      List<Resolved> failed = new ArrayList<>();
      for (Resolved each : open) {
        List<Diagnostic> found = new ArrayList<>();
        boolean defined =
            language.define(
                each.source(),
                each.clause().start(),
                each.clause().end(),
                each.scope(),
                each.contextPackage(),
                found);
        if (!defined) {
          failed.add(each);
          errors.addAll(found);
        } else {
          problems.addAll(found);
        }
      }
      open = failed;
    } while (!open.isEmpty() && open.size() < before);
    problems.addAll(errors);
  }

  private void addInvariant(Resolved resolved) {
    RuleDocument.Clause clause = resolved.clause();
    SourceText source = resolved.source();
    String name = nameOf(resolved);
    if (!isNew(resolved, name)) {
      return;
    }
    RuleComments comments = RuleComments.read(source, clause.comments(), problems);
    Optional<MessageTemplate> message =
        MessageTemplate.parse(
            comments.message(),
            comments.messageOffset(),
            source,
            language,
            resolved.scope(),
            resolved.contextPackage(),
            problems);
    Optional<Expression> condition =
        language
            .parse(
                source,
                clause.start(),
                clause.end(),
                resolved.scope(),
                resolved.contextPackage(),
                problems)
            .filter(expression -> isBoolean(expression, name, source, clause));
    if (condition.isPresent()) {
      constraints.add(
          new OclConstraint(
              name,
              resolved.context(),
              condition.get(),
              new SubExpressions(language),
              comments,
              message.orElse(null),
              resolved.location(),
              Navigations.of(condition.get().ast(), language.environment())));
    }
  }

  private String nameOf(Resolved resolved) {
    String given = resolved.clause().name();
    return given.isEmpty() ? "inv" + unnamed.merge(resolved.context(), 1, Integer::sum) : given;
  }

  /** Whether a name is new; the same words in another document are no fault, but count once. */
  private boolean isNew(Resolved resolved, String name) {
    Resolved first = names.putIfAbsent(Names.qualified(resolved.context()) + "::" + name, resolved);
    if (first == null) {
      return true;
    }
    boolean repeated =
        first.source() != resolved.source() && first.words().equals(resolved.words());
    if (!repeated) {
      String context = resolved.context().getName();
      problems.add(
          Diagnostic.error(
                  "ocl.duplicate",
                  "The invariant '" + name + "' of " + context + " is there twice.",
                  resolved.location())
              .withHint(
                  "The first one is at " + first.location() + ". Give one of them another name."));
    }
    return false;
  }

  private boolean isBoolean(
      Expression expression, String name, SourceText source, RuleDocument.Clause clause) {
    if (expression.type() == language.type("Boolean")) {
      return true;
    }
    boolean collection = language.elementType(expression.type()).isPresent();
    problems.add(
        Diagnostic.error(
                "ocl.not-boolean",
                "The invariant '"
                    + name
                    + "' is of type "
                    + Names.of(expression.type())
                    + ", not Boolean.",
                source.at(clause.keyword()))
            .withHint(
                collection
                    ? "Say what is asked of the elements, with ->forAll(...) or ->exists(...)."
                    : "Compare it with something."));
    return false;
  }
}
