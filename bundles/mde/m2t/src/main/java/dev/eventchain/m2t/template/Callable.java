package dev.eventchain.m2t.template;

import dev.eventchain.m2t.report.Called;
import dev.eventchain.m2t.run.GenerationRun;
import dev.eventchain.m2t.syntax.Place;
import dev.eventchain.m2t.syntax.Syntax.Visibility;
import dev.eventchain.ocl.evaluation.Invalid;
import java.util.List;
import java.util.function.Predicate;
import org.eclipse.emf.ecore.EClassifier;

/** A template or a query, as expressions call it. */
public abstract class Callable implements Called {

  /** A parameter, with a test of whether it takes a value. */
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

  /** Whether it may refuse arguments that its parameters take. */
  public boolean hasGuard() {
    return false;
  }

  /** The static type of a call's result. */
  public abstract EClassifier resultType();

  /** Whether it takes these arguments in this run. */
  public boolean accepts(List<Object> arguments, GenerationRun run) {
    return takes(arguments);
  }

  /** Whether its parameters take these arguments; null goes everywhere. */
  final boolean takes(List<Object> arguments) {
    for (int i = 0; i < arguments.size(); i++) {
      Object argument = arguments.get(i);
      if (argument != null && !parameters.get(i).accepts().test(argument)) {
        return false;
      }
    }
    return true;
  }

  /** The value of a call: of the result type, or an {@link Invalid}. */
  public abstract Object call(List<Object> arguments, GenerationRun run);
}
