package dev.eventchain.constraints.editing;

import dev.eventchain.constraints.document.MemberContext;
import dev.eventchain.constraints.document.RuleDocument;
import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.ocl.ExpressionLanguage;
import dev.eventchain.ocl.Scope;
import dev.eventchain.ocl.assist.TypeNames;
import dev.eventchain.ocl.editing.Mention;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.emf.ecore.ETypedElement;

/** The names of a document that stand outside its expressions. */
final class RuleMentions {

  private final RuleText text;
  private final RuleWorld world;
  private final ExpressionLanguage language;
  private final RuleScopes scopes;

  RuleMentions(RuleText text, RuleWorld world, RuleScopes scopes) {
    this.text = text;
    this.world = world;
    this.language = world.language();
    this.scopes = scopes;
  }

  /** Returns all, in the order of the text. */
  List<Mention> all() {
    List<Mention> found = new ArrayList<>();
    for (RuleDocument.Clause clause : text.document().clauses()) {
      addContext(clause, found);
    }
    List<RuleDocument.Clause> definitions = text.definitions();
    for (int i = 0; i < definitions.size(); i++) {
      addDefinition(definitions.get(i), i, found);
    }
    for (MemberContext member : text.document().members()) {
      addMember(member, found);
    }
    return found.stream().distinct().sorted(Comparator.comparingInt(Mention::start)).toList();
  }

  private void addContext(RuleDocument.Clause clause, List<Mention> into) {
    SourceRange path = scopes.range(clause.context());
    into.addAll(TypeNames.in(path, language.packages()));
    if (!clause.alias().isEmpty()) {
      int start = scopes.aliasStart(clause);
      scopes.classOf(clause).ifPresent(each -> into.add(variable(clause.alias(), start, each)));
    }
  }

  private static Mention variable(String name, int start, EClassifier type) {
    return new Mention(
        start, start + name.length(), Mention.Kind.DECLARATION, name, null, type, null, start);
  }

  private void addDefinition(RuleDocument.Clause clause, int number, List<Mention> into) {
    DefinitionText definition = DefinitionText.of(clause.text());
    Scope scope = scopes.of(clause);
    for (DefinitionText.Parameter each : definition.parameters()) {
      into.add(variable(each.name(), each.start(), scope.typeOf(each.name())));
      into.addAll(TypeNames.in(each.type(), language.packages()));
    }
    into.addAll(TypeNames.in(definition.result(), language.packages()));
    world
        .feature(text.file(), number)
        .ifPresent(
            feature -> {
              Mention.Kind kind =
                  feature instanceof EOperation ? Mention.Kind.OPERATION : Mention.Kind.FEATURE;
              EClassifier type = language.assistant().typeOf((ETypedElement) feature);
              int start = definition.nameStart();
              int end = start + definition.name().length();
              into.add(
                  new Mention(
                      start,
                      end,
                      kind,
                      definition.name(),
                      feature,
                      type,
                      scope.typeOf("self"),
                      Mention.ELSEWHERE));
            });
  }

  private void addMember(MemberContext member, List<Mention> into) {
    SourceRange owner = scopes.range(member.owner());
    into.addAll(TypeNames.in(owner, language.packages()));
    scopes
        .elementOf(member)
        .ifPresent(
            element -> {
              int start = text.source().text().indexOf(member.name(), owner.end());
              Mention.Kind kind =
                  element instanceof EOperation ? Mention.Kind.OPERATION : Mention.Kind.FEATURE;
              into.add(
                  new Mention(
                      start,
                      start + member.name().length(),
                      kind,
                      member.name(),
                      element,
                      language.assistant().typeOf(element),
                      null,
                      Mention.ELSEWHERE));
            });
  }
}
