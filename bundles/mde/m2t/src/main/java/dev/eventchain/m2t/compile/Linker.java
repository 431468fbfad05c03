package dev.eventchain.m2t.compile;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.m2t.library.ServiceLibrary;
import dev.eventchain.m2t.services.Services;
import dev.eventchain.m2t.syntax.Brackets;
import dev.eventchain.m2t.syntax.ModuleLoader;
import dev.eventchain.m2t.syntax.Place;
import dev.eventchain.m2t.syntax.Problems;
import dev.eventchain.m2t.syntax.Syntax;
import dev.eventchain.m2t.syntax.Syntax.Visibility;
import dev.eventchain.m2t.template.CallLibrary;
import dev.eventchain.m2t.template.Callable;
import dev.eventchain.m2t.template.Callable.Parameter;
import dev.eventchain.m2t.template.Query;
import dev.eventchain.m2t.template.Signatures;
import dev.eventchain.m2t.template.Step;
import dev.eventchain.m2t.template.Template;
import dev.eventchain.ocl.Expression;
import dev.eventchain.ocl.ExpressionLanguage;
import dev.eventchain.ocl.Scope;
import dev.eventchain.uml.Uml;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EcorePackage;

/**
 * Linker of modules: first all signatures, then visibility and overriding, then the bodies, which
 * can call everything visible in their module.
 */
public final class Linker {
  /**
   * A module being linked: its declarations, the visible callables, and its expression language.
   */
  record Unit(
      ModuleLoader.Loaded loaded,
      CallLibrary calls,
      ExpressionCompiler expressions,
      Map<Syntax.Template, Template> templates,
      Map<Syntax.Query, Query> queries) {
    Stream<Callable> callables() {
      return Stream.concat(templates.values().stream(), queries.values().stream());
    }
  }

  private final Collection<EPackage> packages;
  private final Map<String, Unit> units = new LinkedHashMap<>();

  /** Number of queries so far. */
  private int queries;

  private final Services services;
  private final Usage usage = new Usage();

  Linker(Collection<EPackage> packages, Services services) {
    this.packages = packages;
    this.services = services;
  }

  /** Returns the templates of the main module, which is the first. */
  public static List<Template> link(
      Map<String, ModuleLoader.Loaded> modules, Collection<EPackage> packages, Services services) {
    Linker linker = new Linker(packages, services);
    linker.declare(modules);
    linker.units.values().forEach(linker::define);
    linker.lint();
    return List.copyOf(linker.units.values().iterator().next().templates().values());
  }

  /** Declares what the modules have, and makes it visible, without the bodies. */
  Map<String, Unit> declare(Map<String, ModuleLoader.Loaded> modules) {
    modules.forEach((name, loaded) -> units.put(name, unit(loaded)));
    units.values().forEach(this::declare);
    units.values().forEach(this::connect);
    units.values().forEach(this::override);
    return units;
  }

  private Unit unit(ModuleLoader.Loaded loaded) {
    CallLibrary calls = new CallLibrary();
    ExpressionLanguage language =
        ExpressionLanguage.of(metamodels(loaded), AcceleoDialect.of(calls, services));
    ExpressionCompiler expressions =
        new ExpressionCompiler(language, loaded.problems(), usage, ExpressionListener.NONE);
    return new Unit(loaded, calls, expressions, new LinkedHashMap<>(), new LinkedHashMap<>());
  }

  private List<EPackage> metamodels(ModuleLoader.Loaded loaded) {
    List<EPackage> found = new ArrayList<>();
    for (SourceRange span : loaded.syntax().metamodels()) {
      String uri = span.text();
      String bare = uri.replaceAll("^'|'$", "");
      Optional<EPackage> metamodel =
          Stream.concat(packages.stream(), Stream.of(EcorePackage.eINSTANCE))
              .flatMap(Linker::withNested)
              .filter(each -> bare.equals(each.getNsURI()))
              .findFirst()
              .or(() -> Uml.metamodel(bare));
      metamodel.ifPresentOrElse(
          found::add,
          () ->
              loaded
                  .problems()
                  .add(
                      CompilerRules.METAMODEL_UNKNOWN,
                      span.start(),
                      "There is no metamodel '" + bare + "'.",
                      known()));
    }
    // The error is reported; with all packages the rest can still be checked.
    return found.isEmpty() ? List.copyOf(packages) : found;
  }

  private static Stream<EPackage> withNested(EPackage metamodel) {
    return Stream.concat(
        Stream.of(metamodel), metamodel.getESubpackages().stream().flatMap(Linker::withNested));
  }

  private String known() {
    List<String> uris =
        packages.stream()
            .flatMap(Linker::withNested)
            .map(EPackage::getNsURI)
            .filter(Objects::nonNull)
            .sorted()
            .toList();
    return uris.isEmpty()
        ? "None is known: name the .ecore file of the metamodel."
        : "Known metamodels: " + String.join(", ", uris) + ".";
  }

  private void declare(Unit unit) {
    for (Syntax.Template template : unit.loaded().syntax().templates()) {
      parameters(template.parameters(), unit)
          .ifPresent(
              parameters ->
                  unit.templates()
                      .put(
                          template,
                          new Template(
                              template.name().text(),
                              template.visibility(),
                              parameters,
                              unit.expressions().language().type("String"),
                              template.guard().isPresent(),
                              template.main(),
                              place(template.name(), unit))));
    }
    for (Syntax.Query query : unit.loaded().syntax().queries()) {
      Optional<List<Parameter>> parameters = parameters(query.parameters(), unit);
      Optional<EClassifier> type = unit.expressions().type(query.type());
      if (parameters.isPresent() && type.isPresent()) {
        unit.queries().put(query, declared(query, parameters.get(), type.get(), unit));
      }
    }
    new Duplicates(unit.loaded().problems()).report(unit.callables().toList(), unit.templates());
  }

  private Query declared(
      Syntax.Query query, List<Parameter> parameters, EClassifier type, Unit unit) {
    return new Query(
        queries++,
        query.name().text(),
        query.visibility(),
        parameters,
        type,
        place(query.name(), unit));
  }

  private static Place place(Syntax.Name name, Unit unit) {
    return new Place(unit.loaded().problems().source(), name.start());
  }

  private Optional<List<Parameter>> parameters(List<Syntax.Variable> declared, Unit unit) {
    List<Parameter> parameters = new ArrayList<>();
    for (Syntax.Variable variable : declared) {
      Optional<EClassifier> type = unit.expressions().type(variable.type().orElseThrow());
      type.ifPresent(
          t ->
              parameters.add(
                  new Parameter(variable.name().text(), t, unit.expressions().instancesOf(t))));
    }
    return parameters.size() == declared.size() ? Optional.of(parameters) : Optional.empty();
  }

  /**
   * Makes callables visible to a module: its own, then those of extended modules, then the public
   * ones of imports.
   */
  private void connect(Unit unit) {
    unit.callables().forEach(unit.calls()::add);
    inherit(unit, unit, new HashSet<>());
    for (Syntax.Name name : unit.loaded().syntax().imports()) {
      Unit imported = named(name, unit);
      if (imported != null) {
        Set<Unit> family = new HashSet<>();
        family.add(imported);
        ancestors(imported, family);
        units.values().stream()
            .filter(family::contains)
            .flatMap(Unit::callables)
            .filter(callable -> callable.visibility() == Visibility.PUBLIC)
            .forEach(unit.calls()::add);
      }
    }
  }

  /**
   * Returns the module that a name refers to in another one; null, with an error, if there is none.
   */
  private Unit named(Syntax.Name name, Unit by) {
    return units.get(by.loaded().names().get(name.text()));
  }

  private void inherit(Unit unit, Unit from, Set<Unit> seen) {
    for (Syntax.Name name : from.loaded().syntax().extended()) {
      Unit extended = named(name, from);
      if (extended != null && seen.add(extended)) {
        extended
            .callables()
            .filter(callable -> callable.visibility() != Visibility.PRIVATE)
            .forEach(unit.calls()::add);
        inherit(unit, extended, seen);
      }
    }
  }

  private void ancestors(Unit unit, Set<Unit> into) {
    for (Syntax.Name name : unit.loaded().syntax().extended()) {
      Unit extended = named(name, unit);
      if (extended != null && into.add(extended)) {
        ancestors(extended, into);
      }
    }
  }

  private void override(Unit unit) {
    unit.templates()
        .forEach(
            (syntax, template) -> {
              for (Syntax.Name name : syntax.overrides()) {
                Optional<Template> other =
                    unit.calls().templates(name.text()).stream()
                        .filter(each -> !unit.templates().containsValue(each))
                        .filter(each -> each.parameters().size() == template.parameters().size())
                        .findFirst();
                override(template, other, name, unit);
              }
            });
  }

  private static void override(
      Template template, Optional<Template> other, Syntax.Name name, Unit unit) {
    if (other.isEmpty()) {
      unit.loaded()
          .problems()
          .add(
              CompilerRules.SUPER,
              name.start(),
              "No extended module has a template '"
                  + name.text()
                  + "' with the same number of parameters.",
              overridable(name.text(), unit));
    } else if (other.get().overrides(template)) {
      unit.loaded()
          .problems()
          .add(
              CompilerRules.SUPER,
              name.start(),
              "The template '" + name.text() + "' already overrides this one.",
              "Let only one of two modules override templates of the other.");
    } else {
      template.override(other.get());
    }
  }

  private static String overridable(String name, Unit unit) {
    List<String> names = unit.calls().names().stream().sorted().toList();
    String meant = NearestName.question(name, names);
    return meant.isEmpty() ? "Name the module in [module ... extends other]." : meant;
  }

  private void define(Unit unit) {
    DiagnosticException.runAt(
        SourceLocation.of(unit.loaded().problems().source().name()),
        () -> {
          unit.queries().forEach((syntax, query) -> define(syntax, query, unit));
          unit.templates().forEach((syntax, template) -> define(syntax, template, unit));
        });
  }

  void define(Syntax.Query syntax, Query query, Unit unit) {
    usage.enter(query);
    if (syntax.value().strip().isEmpty()) {
      defineNothing(syntax, query, unit);
      return;
    }
    Optional<Expression> value =
        unit.expressions().parse(syntax.value(), scope(query, syntax.parameters(), unit));
    if (value.isEmpty()) {
      return;
    }
    ExpressionLanguage language = unit.expressions().language();
    if (value.get().outermostCall().orElse(null) instanceof ServiceLibrary.Call) {
      query.defineService(value.get(), unit.expressions().valuesOf(query.resultType()));
      return;
    }
    if (!new Signatures(language).mayFit(value.get().type(), query.resultType())) {
      String actual = value.get().type().getName();
      unit.loaded()
          .problems()
          .add(
              CompilerRules.QUERY_TYPE,
              syntax.value().start(),
              "The query is of type '%s', not '%s'."
                  .formatted(actual, query.resultType().getName()),
              "Fix the type after the colon, or the expression.");
    }
    query.define(value.get());
  }

  private static void defineNothing(Syntax.Query syntax, Query query, Unit unit) {
    unit.loaded()
        .problems()
        .add(
            CompilerRules.QUERY_EMPTY,
            syntax.name().start(),
            "The query '%s' has no expression: its value is null.".formatted(query.name()),
            "Write the expression between '=' and the end of the tag.");
    query.define(unit.expressions().nothing());
  }

  void define(Syntax.Template syntax, Template template, Unit unit) {
    usage.enter(template);
    Scope scope = scope(template, syntax.parameters(), unit);
    BodyCompiler compiler = new BodyCompiler(unit.expressions(), template);
    Optional<Expression> guard = compiler.condition(syntax.guard(), scope);
    EClassifier text = unit.expressions().language().type("String");
    Optional<Expression> post =
        syntax.post().flatMap(span -> unit.expressions().parse(span, scope.with("self", text)));
    List<Step.Variable> variables = new ArrayList<>();
    Scope inside = compiler.variables(syntax.variables(), scope, variables);
    unit.expressions().listener().body(syntax.name().start(), inside);
    Step body = compiler.body(syntax.body(), inside);
    template.define(new Template.Definition(guard, post, List.copyOf(variables), body));
  }

  /** Reports lint warnings, unless there are errors. */
  private void lint() {
    String main = units.keySet().iterator().next();
    if (Diagnostic.anyError(units.get(main).loaded().problems().found())) {
      return;
    }
    List<Lints.Subject> subjects = new ArrayList<>();
    for (Map.Entry<String, Unit> entry : units.entrySet()) {
      Unit unit = entry.getValue();
      Problems problems = unit.loaded().problems();
      boolean isMain = entry.getKey().equals(main);
      unit.templates()
          .forEach(
              (syntax, template) -> {
                subjects.add(new Lints.Subject(template, syntax.parameters(), isMain, problems));
                Brackets.check(syntax.body(), problems);
              });
      unit.queries()
          .forEach(
              (syntax, query) ->
                  subjects.add(new Lints.Subject(query, syntax.parameters(), isMain, problems)));
    }
    Lints.check(subjects, usage);
  }

  /** Returns a scope with the parameters, the first of which is also self. */
  private static Scope scope(Callable callable, List<Syntax.Variable> declared, Unit unit) {
    Scope scope = unit.expressions().language().root();
    if (!callable.parameters().isEmpty()) {
      scope = scope.with("self", callable.parameters().get(0).type());
    }
    for (int i = 0; i < declared.size(); i++) {
      Parameter parameter = callable.parameters().get(i);
      scope = scope.with(parameter.name(), parameter.type(), declared.get(i).name().start());
    }
    return scope;
  }
}
