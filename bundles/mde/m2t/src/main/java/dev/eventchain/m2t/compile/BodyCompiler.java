package dev.eventchain.m2t.compile;

import dev.eventchain.diagnostics.SourceRange;
import dev.eventchain.m2t.files.FileMode;
import dev.eventchain.m2t.syntax.Place;
import dev.eventchain.m2t.syntax.Syntax;
import dev.eventchain.m2t.syntax.Syntax.Node;
import dev.eventchain.m2t.syntax.SyntaxRules;
import dev.eventchain.m2t.template.CallLibrary;
import dev.eventchain.m2t.template.Step;
import dev.eventchain.m2t.template.Steps;
import dev.eventchain.m2t.template.Template;
import dev.eventchain.ocl.Expression;
import dev.eventchain.ocl.ExpressionLanguage;
import dev.eventchain.ocl.Scope;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.ocl.types.CollectionType;

/** Compiler of the syntax tree of a template into steps, which checks its expressions. */
final class BodyCompiler {
  private static final Step NOTHING = run -> {};

  private final ExpressionCompiler expressions;
  private final ExpressionLanguage language;
  private final Template template;

  BodyCompiler(ExpressionCompiler expressions, Template template) {
    this.expressions = expressions;
    this.language = expressions.language();
    this.template = template;
  }

  Step body(List<Node> nodes, Scope scope) {
    return Step.sequence(nodes.stream().map(node -> step(node, scope)).toList());
  }

  private Step step(Node node, Scope scope) {
    if (node instanceof Syntax.Text text) {
      return new Steps.Text(text.text(), place(text.start()));
    } else if (node instanceof Syntax.Output output) {
      return output(output, scope);
    } else if (node instanceof Syntax.For loop) {
      return forStep(loop, scope);
    } else if (node instanceof Syntax.If choice) {
      return ifStep(choice, scope);
    } else if (node instanceof Syntax.Let choice) {
      return letStep(choice, scope);
    } else if (node instanceof Syntax.File file) {
      return fileStep(file, scope);
    } else if (node instanceof Syntax.Protected area) {
      return protectedStep(area, scope);
    }
    return superStep(node.start());
  }

  private Step superStep(int start) {
    if (template.overridden().isEmpty()) {
      expressions
          .problems()
          .add(
              CompilerRules.SUPER,
              start,
              "[super/] is used in a template that overrides none.",
              "Write [template ... overrides name] in a module that extends another one.");
      return NOTHING;
    }
    if (template.overridden().size() > 1) {
      expressions
          .problems()
          .add(
              CompilerRules.SUPER,
              start,
              "[super/] may mean each of the "
                  + template.overridden().size()
                  + " templates that this one overrides.",
              "Override each of them in a separate template.");
      return NOTHING;
    }
    return new Steps.Super(template.overridden().get(0));
  }

  private Step output(Syntax.Output output, Scope scope) {
    Optional<Expression> value = expressions.parse(output.value(), scope);
    Optional<Steps.Decoration> decoration = decoration(output.decoration(), scope, scope);
    if (output.decoration().guard().isPresent() || !output.decoration().variables().isEmpty()) {
      expressions
          .problems()
          .add(
              SyntaxRules.UNSUPPORTED,
              output.start(),
              "A call cannot have a guard or variables.",
              "Put the call into [if] or [let].");
    }
    if (value.isEmpty() || decoration.isEmpty()) {
      return NOTHING;
    }
    Lints.order(value, "The expression", expressions.problems(), output.value().start());
    return output(value.get(), decoration.get(), place(output.start()));
  }

  private static Step output(Expression value, Steps.Decoration decoration, Place place) {
    boolean decorated = !decoration.equals(Decorations.NONE);
    if (value.outermostCall().orElse(null) instanceof CallLibrary.Call call
        && call.callsTemplates()) {
      return decorated
          ? new Steps.DecoratedCallOutput(value, call, decoration)
          : new Steps.CallOutput(value, call);
    }
    return decorated
        ? new Steps.DecoratedOutput(value, decoration, place)
        : new Steps.Output(value, place);
  }

  private Place place(int offset) {
    return new Place(expressions.problems().source(), offset);
  }

  /**
   * Compiles a decoration; empty if one of its expressions is invalid.
   *
   * @param inside the scope of the separator, which may refer to the item after it
   */
  private Optional<Steps.Decoration> decoration(
      Syntax.Decoration decoration, Scope scope, Scope inside) {
    Decorations around = new Decorations(expressions, scope);
    Decorations between = new Decorations(expressions, inside);
    Optional<Expression> before = around.parse(decoration.before());
    Optional<Expression> separator = between.parse(decoration.separator());
    Optional<Expression> after = around.parse(decoration.after());
    return around.complete() && between.complete()
        ? Optional.of(new Steps.Decoration(before, separator, after))
        : Optional.empty();
  }

  private Step forStep(Syntax.For loop, Scope scope) {
    Optional<Expression> items = expressions.parse(loop.items(), scope);
    Lints.order(items, "The loop", expressions.problems(), loop.items().start());
    EClassifier elements =
        items
            .map(Expression::type)
            .map(t -> language.elementType(t).orElse(t))
            .orElse(language.any());
    Optional<SourceRange> declared = loop.variable().flatMap(Syntax.Variable::type);
    EClassifier type = declared.flatMap(expressions::type).orElse(elements);
    Scope inside = inside(loop, type, scope);
    Optional<Expression> guard = condition(loop.decoration().guard(), inside);
    List<Step.Variable> variables = new ArrayList<>();
    Scope withVariables = variables(loop.decoration().variables(), inside, variables);
    expressions.listener().body(loop.start(), withVariables);
    Step body = body(loop.body(), withVariables);
    Optional<Steps.Decoration> decoration = decoration(loop.decoration(), scope, inside);
    if (items.isEmpty() || decoration.isEmpty()) {
      return NOTHING;
    }
    return new Steps.For(
        loop.variable().map(each -> each.name().text()),
        declared.isEmpty() ? value -> true : accepts(type),
        type.getName(),
        items.get(),
        guard,
        decoration.get(),
        variables,
        body);
  }

  /** Returns the scope inside a loop. */
  private Scope inside(Syntax.For loop, EClassifier type, Scope scope) {
    Scope inside = scope.with("i", language.type("Integer")).with("self", type);
    if (loop.variable().isEmpty()) {
      return inside;
    }
    Syntax.Variable variable = loop.variable().get();
    expressions.listener().variable(variable, type);
    return inside.with(variable.name().text(), type, variable.name().start());
  }

  private Step ifStep(Syntax.If choice, Scope scope) {
    List<Steps.If.Branch> branches = new ArrayList<>();
    for (Syntax.Branch branch : choice.branches()) {
      List<Step.Variable> variables = new ArrayList<>();
      Optional<Expression> condition = condition(Optional.of(branch.condition()), scope);
      Scope inside = variables(branch.variables(), scope, variables);
      expressions.listener().body(branch.start(), inside);
      Step body = body(branch.body(), inside);
      condition.ifPresent(c -> branches.add(new Steps.If.Branch(c, variables, body)));
    }
    return new Steps.If(List.copyOf(branches), body(choice.otherwise(), scope));
  }

  private Step letStep(Syntax.Let choice, Scope scope) {
    List<Steps.Let.Binding> bindings = new ArrayList<>();
    for (Syntax.Binding binding : choice.bindings()) {
      Optional<Expression> value =
          expressions.parse(binding.variable().value().orElseThrow(), scope);
      Optional<EClassifier> type =
          binding.variable().type().isEmpty()
              ? value.map(Expression::type)
              : expressions.type(binding.variable().type().get());
      String name = binding.variable().name().text();
      List<Step.Variable> variables = new ArrayList<>();
      EClassifier known = type.or(() -> value.map(Expression::type)).orElse(language.any());
      expressions.listener().variable(binding.variable(), known);
      Scope inside = scope.with(name, known, binding.variable().name().start());
      Scope withVariables = variables(binding.variables(), inside, variables);
      expressions.listener().body(binding.start(), withVariables);
      Step body = body(binding.body(), withVariables);
      if (value.isPresent() && type.isPresent()) {
        bindings.add(
            new Steps.Let.Binding(
                name,
                accepts(binding, type.get(), value.get(), scope),
                expected(choice, type.get(), value.get(), scope),
                value.get(),
                variables,
                body));
      }
    }
    return new Steps.Let(List.copyOf(bindings), body(choice.otherwise(), scope));
  }

  /** Returns the type whose other kinds of collections would be left out without a word. */
  private static Optional<String> expected(
      Syntax.Let choice, EClassifier type, Expression value, Scope scope) {
    boolean reported =
        choice.bindings().size() == 1
            && choice.otherwise().isEmpty()
            && type instanceof CollectionType<?, ?>
            && value.type() instanceof CollectionType<?, ?>
            && !LetTypes.hasItsKind(value, scope);
    return reported ? Optional.of(type.getName()) : Optional.empty();
  }

  private Predicate<Object> accepts(
      Syntax.Binding binding, EClassifier type, Expression value, Scope scope) {
    return binding
        .variable()
        .type()
        .map(declared -> new LetTypes(expressions).accepts(declared, type, value, scope))
        .orElseGet(() -> accepts(type));
  }

  private Step fileStep(Syntax.File file, Scope scope) {
    Optional<Expression> name = expressions.parse(file.name(), scope);
    String mode = file.mode().map(SourceRange::text).orElse("false");
    Optional<FileMode> constant = fileMode(mode);
    Optional<Expression> computed =
        constant.isPresent() ? Optional.empty() : condition(file.mode(), scope);
    Optional<Expression> charset = file.charset().flatMap(span -> expressions.parse(span, scope));
    Step body = body(file.body(), scope);
    return name.isEmpty()
        ? NOTHING
        : new Steps.File(name.get(), computed, constant.orElse(FileMode.OVERWRITE), charset, body);
  }

  private static Optional<FileMode> fileMode(String mode) {
    return switch (mode) {
      case "false", "overwrite", "'overwrite'" -> Optional.of(FileMode.OVERWRITE);
      case "true", "append", "'append'" -> Optional.of(FileMode.APPEND);
      case "create", "'create'" -> Optional.of(FileMode.CREATE);
      default -> Optional.empty();
    };
  }

  private Step protectedStep(Syntax.Protected area, Scope scope) {
    Optional<Expression> id = expressions.parse(area.id(), scope);
    Decorations prefixes = new Decorations(expressions, scope);
    Optional<Expression> start = prefixes.parse(area.startPrefix());
    Optional<Expression> end = prefixes.parse(area.endPrefix());
    Step body = body(area.body(), scope);
    return id.isEmpty() ? NOTHING : new Steps.Protected(id.get(), start, end, body);
  }

  /** Parses variables into a list and returns the scope with all of them. */
  Scope variables(List<Syntax.Variable> declared, Scope scope, List<Step.Variable> into) {
    Scope inside = scope;
    for (Syntax.Variable variable : declared) {
      Scope before = inside;
      Optional<Expression> value = variable.value().flatMap(v -> expressions.parse(v, before));
      Optional<EClassifier> type =
          variable.type().isPresent()
              ? expressions.type(variable.type().get())
              : value.map(Expression::type);
      String name = variable.name().text();
      inside = inside.with(name, type.orElse(language.any()), variable.name().start());
      expressions.listener().variable(variable, type.orElse(language.any()));
      if (value.isPresent() == variable.value().isPresent()) {
        into.add(new Step.Variable(name, value));
      }
    }
    return inside;
  }

  /** Parses an expression that must be Boolean. */
  Optional<Expression> condition(Optional<SourceRange> span, Scope scope) {
    return span.flatMap(s -> expressions.condition(s, scope));
  }

  private Predicate<Object> accepts(EClassifier type) {
    return expressions.instancesOf(type);
  }

  /** Optional expressions of a tag, with a flag that is true if all of them are valid. */
  private static final class Decorations {
    private static final Steps.Decoration NONE =
        new Steps.Decoration(Optional.empty(), Optional.empty(), Optional.empty());

    private final ExpressionCompiler expressions;
    private final Scope scope;
    private boolean complete = true;

    private Decorations(ExpressionCompiler expressions, Scope scope) {
      this.expressions = expressions;
      this.scope = scope;
    }

    private Optional<Expression> parse(Optional<SourceRange> span) {
      Optional<Expression> parsed = span.flatMap(s -> expressions.parse(s, scope));
      complete &= span.isPresent() == parsed.isPresent();
      return parsed;
    }

    private boolean complete() {
      return complete;
    }
  }
}
