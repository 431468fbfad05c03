package dev.eventchain.constraints;

import dev.eventchain.constraints.document.ConstraintRules;
import dev.eventchain.constraints.document.Contexts;
import dev.eventchain.constraints.document.DocumentImports;
import dev.eventchain.constraints.document.MemberContext;
import dev.eventchain.constraints.document.ResolvedClause;
import dev.eventchain.constraints.document.RuleDocument;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.ocl.Definitions;
import dev.eventchain.ocl.Expression;
import dev.eventchain.ocl.ExpressionLanguage;
import dev.eventchain.ocl.Scope;
import dev.eventchain.ocl.metamodel.Names;
import dev.eventchain.ocl.metamodel.OclAnnotations;
import dev.eventchain.ocl.text.ExpressionRules;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeSet;
import java.util.function.Function;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;

/** Parses rule documents: first all definitions, then the invariants, which may use any of them. */
final class RuleParser {

  private final ExpressionLanguage language;
  private final List<Diagnostic> problems = new ArrayList<>();
  private final List<OclConstraint> constraints = new ArrayList<>();
  private final Map<String, ResolvedClause> names = new HashMap<>();
  private final Map<String, RuleComments> commentsOf = new HashMap<>();
  private final Map<EClassifier, Integer> unnamed = new HashMap<>();

  private final Contexts contexts;
  private final Definitions definitions;
  private final List<MemberContext> members = new ArrayList<>();

  RuleParser(ExpressionLanguage language) {
    this.language = language;
    this.contexts = new Contexts(language.packages(), problems);
    this.definitions = new Definitions(language, problems);
  }

  /**
   * Parses documents and the annotations of the metamodels.
   *
   * @param places returns the location of an element of a metamodel
   */
  OclRules parse(List<SourceText> documents, Function<EObject, SourceLocation> places) {
    return parse(documents, MetamodelRules.read(language, places, problems));
  }

  OclRules parse(List<SourceText> documents) {
    return parse(documents, List.of());
  }

  /**
   * Reads the members and definitions of all documents before any invariant, since invariants, also
   * those of the metamodels, may use them.
   */
  private OclRules parse(List<SourceText> documents, List<ResolvedClause> embedded) {
    List<String> names = documents.stream().map(SourceText::name).toList();
    List<ResolvedClause> clauses = new ArrayList<>();
    List<Diagnostic> empty = new ArrayList<>();
    for (SourceText document : documents) {
      SourceLocation place = SourceLocation.of(document.name());
      clauses.addAll(DiagnosticException.at(place, () -> read(document, names, empty)));
    }
    if (empty.size() < documents.size()) {
      problems.addAll(empty);
    }
    definitions.addAll(
        clauses.stream()
            .filter(each -> each.clause().definition())
            .map(each -> each.definition(language))
            .toList());
    members.forEach(this::implement);
    embedded.forEach(this::addAtItsPlace);
    clauses.stream().filter(each -> !each.clause().definition()).forEach(this::addAtItsPlace);
    definitions.forgetUnusable();
    return new OclRules(constraints, List.copyOf(new TreeSet<>(problems)), names);
  }

  private List<ResolvedClause> read(
      SourceText document, List<String> documents, List<Diagnostic> empty) {
    int before = problems.size();
    RuleDocument parsed = RuleDocument.read(document, problems);
    boolean imports = parsed.imports().stream().anyMatch(e -> DocumentImports.names(e, documents));
    if (parsed.isEmpty() && !imports && problems.size() == before) {
      empty.add(empty(document));
    }
    if (parsed.unchecked() > 0) {
      problems.add(unchecked(parsed.unchecked(), SourceLocation.of(document.name())));
    }
    return resolve(parsed, documents);
  }

  /** Returns the clauses whose classes are known, and stores the members of the document. */
  private List<ResolvedClause> resolve(RuleDocument document, List<String> documents) {
    members.addAll(document.members());
    document.imports().forEach(each -> contexts.check(each, documents));
    List<ResolvedClause> clauses = new ArrayList<>();
    for (RuleDocument.Clause clause : document.clauses()) {
      Optional<ResolvedClause> resolved = contexts.resolve(clause);
      resolved.ifPresent(clauses::add);
      if (resolved.isEmpty() && clause.definition()) {
        definitions.addHomeless(clause.text());
      }
    }
    return clauses;
  }

  private void implement(MemberContext member) {
    contexts
        .resolve(member)
        .ifPresent(
            element -> language.implement(element, member.parameters(), member.text(), problems));
  }

  /** Returns the finding that some conditions are not checked. */
  static Diagnostic unchecked(int conditions, SourceLocation place) {
    return Diagnostic.of(
        ConstraintRules.CONDITION_UNCHECKED,
        Coverage.counted(conditions, "condition")
            + " of operations and initial values not checked: no program runs here.",
        place);
  }

  /** Returns the finding for an empty document; reported unless all documents are empty. */
  private static Diagnostic empty(SourceText document) {
    boolean blank = document.text().isBlank();
    return Diagnostic.of(
            ConstraintRules.DOCUMENT_EMPTY,
            blank ? "The document is empty." : "The document contains only comments.",
            SourceLocation.of(document.name()))
        .withHint("Write invariants: context Class inv Name: ..., or leave it out.");
  }

  private void addAtItsPlace(ResolvedClause invariant) {
    DiagnosticException.runAt(invariant.location(), () -> addInvariant(invariant));
  }

  private void addInvariant(ResolvedClause resolved) {
    String name = nameOf(resolved);
    if (!isNew(resolved, name)) {
      return;
    }
    RuleComments comments = RuleComments.read(resolved.clause(), problems);
    commentsOf.put(qualified(resolved, name), comments);
    Optional<MessageTemplate> message = message(resolved, comments);
    Optional<Expression> condition = condition(resolved, name).filter(c -> isKnown(c, resolved));
    if (condition.isPresent()
        && definitions.isUsable(condition.get())
        && message.stream()
            .flatMap(each -> each.expressions().stream())
            .allMatch(definitions::isUsable)) {
      constraints.add(
          new OclConstraint(
              name,
              resolved.context(),
              condition.get(),
              comments,
              message.orElse(null),
              resolved.location()));
    }
  }

  private Optional<MessageTemplate> message(ResolvedClause resolved, RuleComments comments) {
    SourceRange own = resolved.clause().message();
    Scope scope = resolved.scope(language);
    return own == null
        ? MessageTemplate.parse(
            comments.message(), comments.messageStart(), scope, language, problems)
        : MessageTemplate.parse(own, scope, language, problems);
  }

  private Optional<Expression> condition(ResolvedClause resolved, String name) {
    return language
        .parse(resolved.clause().text(), resolved.scope(language), problems)
        .filter(expression -> isBoolean(expression, name, resolved));
  }

  /** Returns whether each feature that an invariant reads is stored or has an expression. */
  private boolean isKnown(Expression condition, ResolvedClause resolved) {
    Optional<EStructuralFeature> missing =
        condition.navigations().stream()
            .map(Expression.Navigation::feature)
            .filter(OclAnnotations::isComputedInJava)
            .findFirst();
    missing.ifPresent(
        feature ->
            problems.add(
                Diagnostic.of(
                        ConstraintRules.JAVA_MISSING,
                        "This reads '%s' of %s, which only Java code computes."
                            .formatted(feature.getName(), Names.of(feature.getEContainingClass())),
                        resolved.location())
                    .withHint("Give the feature a derivation in OCL, or do without it.")));
    return missing.isEmpty();
  }

  private String nameOf(ResolvedClause resolved) {
    String given = resolved.clause().name();
    return given.isEmpty() ? "inv" + unnamed.merge(resolved.context(), 1, Integer::sum) : given;
  }

  /**
   * Returns whether a name is new; identical clauses in other documents are allowed, but count
   * once.
   */
  private boolean isNew(ResolvedClause resolved, String name) {
    ResolvedClause first = names.putIfAbsent(qualified(resolved, name), resolved);
    if (first == null) {
      return true;
    }
    if (resolved.repeats(first)) {
      commentsOf.get(qualified(resolved, name)).addRepeated(resolved.clause());
    } else {
      String context = resolved.context().getName();
      problems.add(
          Diagnostic.of(
                  ExpressionRules.DUPLICATE,
                  "The invariant '" + name + "' of " + context + " is declared twice.",
                  resolved.location())
              .withHint("Give one of them another name.")
              .withRelated(first.location()));
    }
    return false;
  }

  private static String qualified(ResolvedClause resolved, String name) {
    return Names.qualified(resolved.context()) + "::" + name;
  }

  private boolean isBoolean(Expression expression, String name, ResolvedClause resolved) {
    if (expression.type() == language.type("Boolean")) {
      return true;
    }
    boolean collection = language.elementType(expression.type()).isPresent();
    problems.add(
        Diagnostic.of(
                ConstraintRules.NOT_BOOLEAN,
                "The invariant '"
                    + name
                    + "' is of type "
                    + Names.of(expression.type())
                    + ", not Boolean.",
                resolved.location())
            .withHint(
                collection
                    ? "State the condition on the elements, with ->forAll(...) or ->exists(...)."
                    : "Compare it with something."));
    return false;
  }
}
