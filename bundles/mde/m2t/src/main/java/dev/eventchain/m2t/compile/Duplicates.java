package dev.eventchain.m2t.compile;

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

/** Finds callables of a module that no call could tell apart. */
record Duplicates(Problems problems) {

  private static final String ID = "m2t.name.duplicate";

  /**
   * Reports them.
   *
   * @param callables of the module, in the order of the text
   * @param templates those that are templates, by their declarations
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
          // One with a guard is asked before those without, and each main template is run.
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
    problems.error(
        ID,
        query.place().offset(),
        "There are two queries '" + query.name() + "' with the same parameters.",
        "Rename one of them.");
  }

  private void warn(Syntax.Template template) {
    problems.warning(
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

  /** Classes of several metamodels may have the same name. */
  private static String name(EClassifier type) {
    String owner = type.getEPackage() == null ? "" : type.getEPackage().getNsURI() + "#";
    return owner + type.getName();
  }
}
