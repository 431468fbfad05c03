package dev.eventchain.m2t.compile;

import dev.eventchain.m2t.services.Services;
import dev.eventchain.m2t.syntax.ModuleLoader;
import dev.eventchain.m2t.syntax.Problems;
import dev.eventchain.m2t.syntax.Syntax;
import dev.eventchain.m2t.template.Callable;
import dev.eventchain.m2t.template.Query;
import dev.eventchain.m2t.template.Template;
import dev.eventchain.ocl.ExpressionLanguage;
import java.util.ArrayList;
import java.util.Collection;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.eclipse.emf.ecore.EPackage;

/**
 * A module and those that it imports, declared but not compiled, for editors: their bodies are
 * compiled one at a time, and findings go nowhere. Bodies may be newer than the declarations, as
 * long as these are the same.
 */
public final class LinkedModules {

  /** The number of a template or a query among those of its module. */
  public record Declaration(String module, boolean template, int number) {}

  private final Collection<EPackage> packages;
  private final Linker.Unit main;
  private final List<Template> templates = new ArrayList<>();
  private final List<Query> queries = new ArrayList<>();
  private final IdentityHashMap<Callable, Declaration> declarations = new IdentityHashMap<>();

  private LinkedModules(Collection<EPackage> packages, Map<String, ModuleLoader.Loaded> modules) {
    this.packages = packages;
    Map<String, Linker.Unit> units = new Linker(packages, without()).declare(modules);
    this.main = units.values().iterator().next();
    main.loaded().syntax().templates().forEach(each -> templates.add(main.templates().get(each)));
    main.loaded().syntax().queries().forEach(each -> queries.add(main.queries().get(each)));
    units.forEach(this::number);
  }

  private static Services without() {
    return new Services(Optional.empty());
  }

  /** Declares modules, the main one first. */
  public static LinkedModules of(
      Map<String, ModuleLoader.Loaded> modules, Collection<EPackage> packages) {
    return new LinkedModules(packages, modules);
  }

  private void number(String name, Linker.Unit unit) {
    Syntax.Module syntax = unit.loaded().syntax();
    for (int i = 0; i < syntax.templates().size(); i++) {
      declarations.put(
          unit.templates().get(syntax.templates().get(i)), new Declaration(name, true, i));
    }
    for (int i = 0; i < syntax.queries().size(); i++) {
      declarations.put(
          unit.queries().get(syntax.queries().get(i)), new Declaration(name, false, i));
    }
  }

  /** Returns the language of the main module's expressions. */
  public ExpressionLanguage language() {
    return main.expressions().language();
  }

  /** Returns the names of all that the main module can call. */
  public Collection<String> callable() {
    return main.calls().names();
  }

  /** Returns the template of a number in the main module; empty if it cannot be declared. */
  public Optional<Template> template(int number) {
    return Optional.ofNullable(templates.get(number));
  }

  /** Returns the query of a number in the main module; empty if it cannot be declared. */
  public Optional<Query> query(int number) {
    return Optional.ofNullable(queries.get(number));
  }

  /** Returns where something is declared. */
  public Optional<Declaration> declaration(Callable callable) {
    return Optional.ofNullable(declarations.get(callable));
  }

  /** Compiles a template of the main module; its findings are lost. */
  public synchronized void compile(
      Syntax.Template syntax, int number, ExpressionListener listener) {
    template(number)
        .ifPresent(
            template -> new Linker(packages, without()).define(syntax, template, heard(listener)));
  }

  /** Compiles a query of the main module; its findings are lost. */
  public synchronized void compile(Syntax.Query syntax, int number, ExpressionListener listener) {
    query(number)
        .ifPresent(query -> new Linker(packages, without()).define(syntax, query, heard(listener)));
  }

  private Linker.Unit heard(ExpressionListener listener) {
    Problems lost = Problems.ignored(main.loaded().problems().source());
    ExpressionCompiler compiler = new ExpressionCompiler(language(), lost, new Usage(), listener);
    return new Linker.Unit(main.loaded(), main.calls(), compiler, Map.of(), Map.of());
  }
}
