package dev.eventchain.m2t.compile;

import dev.eventchain.diagnostics.Rule;
import dev.eventchain.m2t.syntax.Problems;
import dev.eventchain.m2t.syntax.Syntax;
import dev.eventchain.m2t.template.Callable;
import dev.eventchain.m2t.template.Query;
import dev.eventchain.m2t.template.Template;
import java.util.Collection;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import org.eclipse.emf.ecore.EClassifier;

/** Check for callables of a module that no call can distinguish. */
record Duplicates(Problems problems) {

  private static final Rule ID = CompilerRules.NAME_DUPLICATE;

  /**
   * Reports duplicates.
   *
   * @param callables the callables of the module, in the order of the text
   * @param templates the templates among them, by their declarations
   */
  void report(Collection<Callable> callables, Map<Syntax.Template, Template> templates) {
    Set<String> queries = new HashSet<>();
    callables.stream()
        .filter(Query.class::isInstance)
        .filter(query -> !queries.add(signature(query)))
        .forEach(this::refuse);
    Set<String> unguarded = new HashSet<>();
    templates.forEach(
        (declaration, template) -> {
          // A callable with a guard takes precedence over those without; all main templates are
          // run.
          boolean isAlike =
              declaration.guard().isEmpty()
                  && declaration.overrides().isEmpty()
                  && !declaration.main();
          if (isAlike && !unguarded.add(signature(template))) {
            warn(declaration);
          }
        });
  }

  private void refuse(Callable query) {
    problems.add(
        ID,
        query.place().offset(),
        "There are two queries '" + query.name() + "' with the same parameters.",
        "Rename one of them.");
  }

  private void warn(Syntax.Template template) {
    problems.warn(
        ID,
        template.name().start(),
        "This template is never called: an earlier one is also called '"
            + template.name().text()
            + "', has the same parameters, and no guard.",
        "Rename one of them, or give one of them a guard.");
  }

  private static String signature(Callable callable) {
    return callable.name() + callable.parameters().stream().map(p -> name(p.type())).toList();
  }

  /** Returns the name of a type, unique across metamodels with equal class names. */
  private static String name(EClassifier type) {
    String owner = type.getEPackage() == null ? "" : type.getEPackage().getNsURI() + "#";
    return owner + type.getName();
  }
}
