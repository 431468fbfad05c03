package dev.eventchain.ocl;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeSet;
import org.eclipse.emf.ecore.EClass;

/** Parses rule documents: first all definitions, then the invariants, which may use any of them. */
final class RuleParser {

  private final ExpressionLanguage language;
  private final List<Diagnostic> problems = new ArrayList<>();
  private final List<OclConstraint> constraints = new ArrayList<>();
  private final Map<String, ResolvedClause> names = new HashMap<>();
  private final Map<String, RuleComments> commentsOf = new HashMap<>();
  private final Map<EClass, Integer> unnamed = new HashMap<>();

  private final Contexts contexts;
  private final Definitions definitions;

  RuleParser(ExpressionLanguage language) {
    this.language = language;
    this.contexts = new Contexts(language.packages(), problems);
    this.definitions = new Definitions(language, problems);
  }

  OclRules parse(List<SourceText> documents) {
    List<ResolvedClause> clauses = new ArrayList<>();
    for (SourceText document : documents) {
      RuleDocument parsed = RuleDocument.read(document, problems);
      parsed.imports().forEach(contexts::check);
      for (RuleDocument.Clause clause : parsed.clauses()) {
        Optional<ResolvedClause> resolved = contexts.resolve(clause);
        resolved.ifPresent(clauses::add);
        if (resolved.isEmpty() && clause.definition()) {
          definitions.addHomeless(clause);
        }
      }
    }
    definitions.addAll(clauses.stream().filter(each -> each.clause().definition()).toList());
    clauses.stream().filter(each -> !each.clause().definition()).forEach(this::addInvariant);
    definitions.forgetUnusable();
    List<String> names = documents.stream().map(SourceText::name).toList();
    return new OclRules(constraints, List.copyOf(new TreeSet<>(problems)), names);
  }

  private void addInvariant(ResolvedClause resolved) {
    RuleDocument.Clause clause = resolved.clause();
    String name = nameOf(resolved);
    if (!isNew(resolved, name)) {
      return;
    }
    RuleComments comments = RuleComments.read(clause, problems);
    commentsOf.put(qualified(resolved, name), comments);
    Optional<MessageTemplate> message =
        MessageTemplate.parse(
            comments.message(), comments.messageStart(), resolved, language, problems);
    Optional<Expression> condition = condition(resolved, name);
    if (condition.isPresent()
        && definitions.isUsable(condition.get().ast())
        && message.stream()
            .flatMap(each -> each.expressions().stream())
            .allMatch(each -> definitions.isUsable(each.ast()))) {
      constraints.add(
          new OclConstraint(
              name,
              resolved.context(),
              condition.get(),
              new SubExpressions(language),
              comments,
              message.orElse(null),
              resolved.location(),
              () -> Navigations.of(condition.get().ast(), language.environment())));
    }
  }

  private Optional<Expression> condition(ResolvedClause resolved, String name) {
    return language
        .parse(resolved.clause().text(), resolved.scope(), resolved.contextPackage(), problems)
        .filter(expression -> isBoolean(expression, name, resolved));
  }

  private String nameOf(ResolvedClause resolved) {
    String given = resolved.clause().name();
    return given.isEmpty() ? "inv" + unnamed.merge(resolved.context(), 1, Integer::sum) : given;
  }

  /** Whether a name is new; the same words in another document are no fault, but count once. */
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
          Diagnostic.error(
                  "ocl.duplicate",
                  "The invariant '" + name + "' of " + context + " is there twice.",
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
        Diagnostic.error(
                "ocl.not-boolean",
                "The invariant '"
                    + name
                    + "' is of type "
                    + Names.of(expression.type())
                    + ", not Boolean.",
                resolved.location())
            .withHint(
                collection
                    ? "Say what is asked of the elements, with ->forAll(...) or ->exists(...)."
                    : "Compare it with something."));
    return false;
  }
}
