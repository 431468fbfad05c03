package dev.eventchain.constraints.editing;

import dev.eventchain.constraints.document.Contexts;
import dev.eventchain.constraints.document.MemberContext;
import dev.eventchain.constraints.document.ResolvedClause;
import dev.eventchain.constraints.document.RuleDocument;
import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.ocl.ExpressionLanguage;
import dev.eventchain.ocl.Scope;
import java.util.ArrayList;
import java.util.Optional;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.emf.ecore.ETypedElement;

/** The variables in the clauses of a document, with the places where they are declared. */
final class RuleScopes {

  private final RuleText text;
  private final ExpressionLanguage language;
  private final Contexts contexts;

  RuleScopes(RuleText text, ExpressionLanguage language) {
    this.text = text;
    this.language = language;
    this.contexts = new Contexts(language.packages(), new ArrayList<>());
  }

  /** Returns the class of a clause. */
  Optional<EClassifier> classOf(RuleDocument.Clause clause) {
    return contexts.resolve(clause).map(ResolvedClause::context);
  }

  /** Returns the operation or feature that a context names. */
  Optional<ETypedElement> elementOf(MemberContext member) {
    return contexts.resolve(member);
  }

  Scope of(RuleDocument.Clause clause) {
    Optional<ResolvedClause> resolved = contexts.resolve(clause);
    Scope scope = language.root();
    if (resolved.isPresent()) {
      scope = scope.in(resolved.get().contextPackage()).with("self", resolved.get().context());
      if (!clause.alias().isEmpty()) {
        int alias = aliasStart(clause);
        scope = scope.with(clause.alias(), resolved.get().context(), alias);
      }
    }
    if (clause.definition()) {
      for (DefinitionText.Parameter each : DefinitionText.of(clause.text()).parameters()) {
        EClassifier type =
            each.type().isEmpty()
                ? language.any()
                : language.type(each.type(), new ArrayList<>()).orElse(language.any());
        scope = scope.with(each.name(), type, each.start());
      }
    }
    return scope;
  }

  /** Returns the offset of an alias, which is before the class. */
  int aliasStart(RuleDocument.Clause clause) {
    int at = offset(clause.context()) - 1;
    return text.source().text().lastIndexOf(clause.alias(), at);
  }

  private int offset(RuleDocument.Path path) {
    return text.source().offset(path.location().line(), path.location().column());
  }

  Scope of(MemberContext member) {
    Optional<ETypedElement> element = contexts.resolve(member);
    Scope scope = language.root();
    if (element.isPresent() && element.get().eContainer() instanceof EClass owner) {
      scope = scope.in(owner.getEPackage()).with("self", owner);
      if (element.get() instanceof EOperation operation) {
        for (int i = 0; i < operation.getEParameters().size(); i++) {
          EClassifier type = language.assistant().typeOf(operation.getEParameters().get(i));
          scope = scope.with(member.parameters().get(i), type);
        }
      }
    }
    return scope;
  }

  /** Returns the range of a name. */
  SourceRange range(RuleDocument.Path path) {
    int start = offset(path);
    int end = Math.min(text.source().text().length(), start + path.toString().length());
    return text.source().range(start, end);
  }
}
