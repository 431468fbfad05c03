package dev.eventchain.m2t.template;

import dev.eventchain.m2t.report.Called;
import dev.eventchain.m2t.run.GenerationRun;
import dev.eventchain.m2t.syntax.Place;
import dev.eventchain.m2t.syntax.Syntax.Visibility;
import dev.eventchain.ocl.evaluation.Invalid;
import java.util.List;
import java.util.function.Predicate;
import org.eclipse.emf.ecore.EClassifier;

/** A template or a query that expressions can call. */
public abstract class Callable implements Called {

  /** A parameter with a test for accepted values. */
  public record Parameter(String name, EClassifier type, Predicate<Object> accepts) {}

  private final String name;
  private final Visibility visibility;
  private final List<Parameter> parameters;
  private final Place place;

  Callable(String name, Visibility visibility, List<Parameter> parameters, Place place) {
    this.name = name;
    this.visibility = visibility;
    this.parameters = List.copyOf(parameters);
    this.place = place;
  }

  @Override
  public final String name() {
    return name;
  }

  public final Visibility visibility() {
    return visibility;
  }

  public final List<Parameter> parameters() {
    return parameters;
  }

  @Override
  public final Place place() {
    return place;
  }

  /** Returns whether it may refuse arguments that its parameters accept. */
  public boolean hasGuard() {
    return false;
  }

  /** Returns the static type of a call's result. */
  public abstract EClassifier resultType();

  /** Returns whether it accepts the arguments in a run. */
  public boolean accepts(List<Object> arguments, GenerationRun run) {
    return takes(arguments);
  }

  /** Returns whether its parameters accept the arguments; null is always accepted. */
  final boolean takes(List<Object> arguments) {
    for (int i = 0; i < arguments.size(); i++) {
      Object argument = arguments.get(i);
      if (argument != null && !parameters.get(i).accepts().test(argument)) {
        return false;
      }
    }
    return true;
  }

  /** Returns the value of a call: of the result type, or an {@link Invalid}. */
  public abstract Object call(List<Object> arguments, GenerationRun run);
}
