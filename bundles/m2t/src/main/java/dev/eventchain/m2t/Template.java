package dev.eventchain.m2t;

import dev.eventchain.m2t.Syntax.Visibility;
import dev.eventchain.ocl.Evaluation;
import dev.eventchain.ocl.Expression;
import dev.eventchain.ocl.Invalid;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.eclipse.emf.ecore.EClassifier;

/** A template: writes text, which is the value of a call. */
final class Template extends Callable {

  /** What a template does. */
  record Definition(
      Optional<Expression> guard,
      Optional<Expression> post,
      List<Step.Variable> variables,
      Step body) {}

  private final EClassifier resultType;
  private final boolean guarded;
  private final boolean main;
  private final List<Template> overriddenBy = new ArrayList<>();
  private Optional<Template> overrides = Optional.empty();
  private Definition definition;

  Template(
      String name,
      Visibility visibility,
      List<Parameter> parameters,
      EClassifier resultType,
      boolean guarded,
      boolean main,
      Place place) {
    super(name, visibility, parameters, place);
    this.resultType = resultType;
    this.guarded = guarded;
    this.main = main;
  }

  /** Completes the template, whose body may call any other callable. */
  void define(Definition newDefinition) {
    definition = newDefinition;
  }

  /** Puts this template in the place of another one, wherever that is called. */
  void override(Template other) {
    overrides = Optional.of(other);
    other.overriddenBy.add(this);
  }

  /** The template that {@code [super/]} means. */
  Optional<Template> overridden() {
    return overrides;
  }

  boolean isMain() {
    return main;
  }

  @Override
  boolean hasGuard() {
    return guarded;
  }

  @Override
  EClassifier resultType() {
    return resultType;
  }

  @Override
  boolean accepts(List<Object> arguments, GenerationRun run) {
    return super.accepts(arguments, run) && (definition.guard().isEmpty() || guard(arguments, run));
  }

  private boolean guard(List<Object> arguments, GenerationRun run) {
    run.enter(this, arguments);
    bind(arguments, run.evaluation());
    try {
      return run.holds(definition.guard().get());
    } finally {
      unbind(run.evaluation());
      run.leave();
    }
  }

  @Override
  Object call(List<Object> arguments, GenerationRun run) {
    for (Template other : overriddenBy) {
      if (other.accepts(arguments, run)) {
        return other.call(arguments, run);
      }
    }
    return callExactly(arguments, run);
  }

  /** Calls this template even if another one overrides it. */
  Object callExactly(List<Object> arguments, GenerationRun run) {
    run.enter(this, arguments);
    bind(arguments, run.evaluation());
    try {
      String text =
          run.textOf(() -> Step.withVariables(definition.variables(), run, definition.body()));
      return definition.post().isEmpty() ? text : post(text, run);
    } finally {
      unbind(run.evaluation());
      run.leave();
    }
  }

  private Object post(String text, GenerationRun run) {
    run.evaluation().bind("self", text);
    Object result = run.evaluate(definition.post().get());
    run.evaluation().unbind("self");
    return result instanceof Invalid ? "" : Texts.of(result);
  }

  private void bind(List<Object> arguments, Evaluation evaluation) {
    evaluation.bind("self", arguments.isEmpty() ? null : arguments.get(0));
    for (int i = 0; i < arguments.size(); i++) {
      evaluation.bind(parameters().get(i).name(), arguments.get(i));
    }
  }

  private void unbind(Evaluation evaluation) {
    for (int i = parameters().size() - 1; i >= 0; i--) {
      evaluation.unbind(parameters().get(i).name());
    }
    evaluation.unbind("self");
  }
}
