package dev.eventchain.m2t.template;

import dev.eventchain.m2t.run.GenerationRun;
import dev.eventchain.m2t.syntax.Place;
import dev.eventchain.m2t.syntax.Syntax.Visibility;
import dev.eventchain.m2t.text.OriginMarks;
import dev.eventchain.m2t.text.OutputBuffer;
import dev.eventchain.m2t.text.Undefined;
import dev.eventchain.ocl.Expression;
import dev.eventchain.ocl.evaluation.Evaluation;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.eclipse.emf.ecore.EClassifier;

/** A template, which writes text; the text is the value of a call. */
public final class Template extends Callable {

  /** Body and conditions of a template. */
  public record Definition(
      Optional<Expression> guard,
      Optional<Expression> post,
      List<Step.Variable> variables,
      Step body) {}

  private final EClassifier resultType;
  private final boolean guarded;
  private final boolean main;
  private final List<Template> overridden = new ArrayList<>();
  private Definition definition;

  public Template(
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
  public void define(Definition newDefinition) {
    definition = newDefinition;
  }

  /** Makes this template override another one, wherever it is visible to calls. */
  public void override(Template other) {
    overridden.add(other);
  }

  /** Returns the overridden templates; if there is exactly one, {@code [super/]} refers to it. */
  public List<Template> overridden() {
    return overridden;
  }

  /** Returns whether this template overrides another one, directly or indirectly. */
  public boolean overrides(Template other) {
    return overridden.stream().anyMatch(each -> each == other || each.overrides(other));
  }

  public boolean isMain() {
    return main;
  }

  @Override
  public boolean hasGuard() {
    return guarded;
  }

  @Override
  public EClassifier resultType() {
    return resultType;
  }

  @Override
  public boolean accepts(List<Object> arguments, GenerationRun run) {
    return super.accepts(arguments, run) && (definition.guard().isEmpty() || guard(arguments, run));
  }

  private boolean guard(List<Object> arguments, GenerationRun run) {
    run.enter(this, arguments);
    int bindings = bind(arguments, run.evaluation());
    try {
      return run.holds(definition.guard().get());
    } catch (VirtualMachineError e) {
      run.calls().keep();
      throw e;
    } finally {
      run.evaluation().unbindTo(bindings);
      run.leave();
    }
  }

  /** Returns the text as a value, indented like the current line, as if it were written there. */
  @Override
  public Object call(List<Object> arguments, GenerationRun run) {
    OutputBuffer output = run.output();
    String indentation = output.currentIndentation();
    OutputBuffer.Part part = output.beginText();
    try {
      write(arguments, run, indentation);
      return output.textOf(part);
    } finally {
      output.cut(part);
    }
  }

  /**
   * Writes the text of a call.
   *
   * @param indentation the text inserted after each of its line breaks
   */
  void write(List<Object> arguments, GenerationRun run, String indentation) {
    run.enter(this, arguments);
    int bindings = bind(arguments, run.evaluation());
    OutputBuffer.Part part = run.output().beginIndented(indentation);
    try {
      if (definition.post().isEmpty()) {
        Step.withVariables(definition.variables(), run, definition.body());
      } else {
        writePost(definition.post().get(), run);
      }
    } catch (VirtualMachineError e) {
      run.calls().keep();
      throw e;
    } finally {
      run.output().end(part);
      run.evaluation().unbindTo(bindings);
      run.leave();
    }
  }

  private void writePost(Expression post, GenerationRun run) {
    OutputBuffer output = run.output();
    OutputBuffer.Part part = output.beginText();
    String text;
    Optional<OriginMarks> origins;
    try {
      Step.withVariables(definition.variables(), run, definition.body());
      text = output.textOf(part);
      origins = output.marksOf(part);
    } finally {
      output.cut(part);
    }
    run.evaluation().bind("self", text);
    Object result = run.evaluate(post, Undefined.TEXT);
    run.evaluation().unbind("self");
    String changed = Undefined.textOf(result);
    int from = origins.isPresent() ? text.indexOf(changed) : -1;
    if (from < 0) {
      run.writer().append(changed, post);
    } else {
      output.append(changed, origins.get().between(from, from + changed.length()));
    }
  }

  /** Binds the parameters and self, and returns the number of earlier bindings. */
  private int bind(List<Object> arguments, Evaluation evaluation) {
    int bindings = evaluation.bindings();
    evaluation.bind("self", arguments.isEmpty() ? null : arguments.get(0));
    for (int i = 0; i < arguments.size(); i++) {
      evaluation.bind(parameters().get(i).name(), arguments.get(i));
    }
    return bindings;
  }
}
