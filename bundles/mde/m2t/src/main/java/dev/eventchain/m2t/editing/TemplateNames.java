package dev.eventchain.m2t.editing;

import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.m2t.syntax.Syntax;
import dev.eventchain.m2t.template.Callable;
import dev.eventchain.m2t.template.Template;
import dev.eventchain.ocl.ExpressionLanguage;
import dev.eventchain.ocl.assist.TypeNames;
import dev.eventchain.ocl.editing.Mention;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.eclipse.emf.ecore.EClassifier;

/** The names of a template file that stand outside its expressions. */
final class TemplateNames {

  private final TemplateWorld world;
  private final ExpressionLanguage language;

  TemplateNames(TemplateWorld world) {
    this.world = world;
    this.language = world.linked().language();
  }

  /** Returns the names in the head of a template or query, and those its tags declare. */
  List<Mention> of(TemplateUnit unit, CallableKey key) {
    List<Mention> found = new ArrayList<>();
    EClassifier result = unit.callable().map(Callable::resultType).orElse(language.any());
    found.add(callable(unit.name(), key, result));
    for (int i = 0; i < unit.parameters().size(); i++) {
      Syntax.Variable parameter = unit.parameters().get(i);
      int number = i;
      EClassifier type =
          unit.callable().map(each -> each.parameters().get(number).type()).orElse(language.any());
      found.add(Compiled.declaration(parameter.name(), type));
      parameter.type().ifPresent(each -> addTypes(each, found));
    }
    unit.resultType().ifPresent(each -> addTypes(each, found));
    for (Syntax.Name name : unit.overrides()) {
      overridden(unit, name)
          .flatMap(world::key)
          .ifPresent(other -> found.add(callable(name, other, result)));
    }
    found.addAll(unit.compiled().names());
    return found;
  }

  private static Optional<Template> overridden(TemplateUnit unit, Syntax.Name name) {
    return unit.callable()
        .filter(Template.class::isInstance)
        .flatMap(
            each ->
                ((Template) each)
                    .overridden().stream()
                        .filter(other -> other.name().equals(name.text()))
                        .findFirst());
  }

  private void addTypes(SourceRange range, List<Mention> into) {
    into.addAll(TypeNames.in(range, language.packages()));
  }

  private static Mention callable(Syntax.Name name, CallableKey key, EClassifier type) {
    return new Mention(
        name.start(),
        name.start() + name.text().length(),
        Mention.Kind.LIBRARY_OPERATION,
        name.text(),
        key,
        type,
        null,
        Mention.ELSEWHERE);
  }
}
