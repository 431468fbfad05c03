package dev.eventchain.m2t.editing;

import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.m2t.compile.LinkedModules;
import dev.eventchain.m2t.syntax.ModuleLoader;
import dev.eventchain.m2t.syntax.Syntax;
import dev.eventchain.m2t.template.Callable;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.eclipse.emf.ecore.EPackage;

/**
 * Declarations of a module and those that it imports. It stays the same until a head changes: what
 * is written in bodies does not count.
 */
final class TemplateWorld {

  private final List<EPackage> metamodels;
  private final List<String> signatures;
  private final Map<String, Path> files;
  private final LinkedModules linked;

  /**
   * Links modules.
   *
   * @param files the files of the modules by their names
   */
  TemplateWorld(
      Map<String, ModuleLoader.Loaded> modules,
      Map<String, Path> files,
      List<EPackage> metamodels) {
    this.metamodels = metamodels;
    this.signatures = signatures(modules);
    this.files = files;
    this.linked = LinkedModules.of(modules, metamodels);
  }

  boolean isOf(Map<String, ModuleLoader.Loaded> modules, List<EPackage> present) {
    return metamodels.equals(present) && signatures.equals(signatures(modules));
  }

  LinkedModules linked() {
    return linked;
  }

  /** Returns what a call may call, by its place. */
  Optional<CallableKey> key(Callable callable) {
    return linked
        .declaration(callable)
        .filter(each -> files.containsKey(each.module()))
        .map(each -> new CallableKey(files.get(each.module()), each.template(), each.number()));
  }

  private static List<String> signatures(Map<String, ModuleLoader.Loaded> modules) {
    List<String> all = new ArrayList<>();
    modules.forEach(
        (name, loaded) -> {
          Syntax.Module module = loaded.syntax();
          all.add(name + loaded.names() + names(module.extended()) + names(module.imports()));
          module.metamodels().forEach(each -> all.add(each.text()));
          for (Syntax.Template each : module.templates()) {
            String head = "template " + each.visibility() + names(each.overrides());
            all.add(head + each.guard().isPresent() + head(each.name(), each.parameters()));
          }
          for (Syntax.Query each : module.queries()) {
            String head = "query " + each.visibility() + each.type().text();
            all.add(head + head(each.name(), each.parameters()));
          }
        });
    return all;
  }

  private static List<String> names(List<Syntax.Name> names) {
    return names.stream().map(Syntax.Name::text).toList();
  }

  private static String head(Syntax.Name name, List<Syntax.Variable> parameters) {
    StringBuilder head = new StringBuilder(name.text());
    for (Syntax.Variable each : parameters) {
      String type = each.type().map(SourceRange::text).orElse("");
      head.append(", ").append(each.name().text()).append(" : ").append(type);
    }
    return head.toString();
  }
}
