package dev.eventchain.m2t.template;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.m2t.run.GenerationRun;
import dev.eventchain.m2t.services.ServiceException;
import dev.eventchain.m2t.services.ServiceValues;
import dev.eventchain.m2t.syntax.Place;
import dev.eventchain.m2t.syntax.Syntax.Visibility;
import dev.eventchain.ocl.Expression;
import dev.eventchain.ocl.dialect.OperationLibrary;
import dev.eventchain.ocl.evaluation.Evaluation;
import dev.eventchain.ocl.evaluation.Invalid;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.impl.BasicEObjectImpl;

/**
 * A query: a named expression whose values are cached during a run. Values whose evaluation began a
 * file or a protected area are not cached, because they belong to the place of the call.
 */
public final class Query extends Callable {
  /** Cached value for null. */
  private static final Object NULL = new Object();

  private final int number;
  private final EClassifier resultType;
  private Expression value;
  private Optional<Predicate<Object>> accepts = Optional.empty();

  /**
   * Creates a query that is not complete yet.
   *
   * @param number a small number, unique among the queries that are compiled together
   */
  public Query(
      int number,
      String name,
      Visibility visibility,
      List<Parameter> parameters,
      EClassifier resultType,
      Place place) {
    super(name, visibility, parameters, place);
    this.number = number;
    this.resultType = resultType;
  }

  /** Completes the query, whose value may call any other callable. */
  public void define(Expression newValue) {
    value = newValue;
  }

  /** Completes a query on a Java service, with a test for accepted results. */
  public void defineService(Expression newValue, Predicate<Object> newAccepts) {
    value = newValue;
    accepts = Optional.of(newAccepts);
  }

  /** Returns whether its value is what a Java service gives. */
  boolean isService() {
    return accepts.isPresent();
  }

  /** Returns the calls in its value. */
  Stream<OperationLibrary.Implementation> calls() {
    return value.libraryCalls().stream().map(Expression.LibraryCall::implementation);
  }

  @Override
  public EClassifier resultType() {
    return resultType;
  }

  @Override
  public Object call(List<Object> arguments, GenerationRun run) {
    for (Object argument : arguments) {
      // Tests of classes are faster than a negative test of an interface.
      if (!(argument instanceof BasicEObjectImpl)
          && !(argument instanceof String)
          && argument instanceof Collection<?>) {
        return evaluate(arguments, run);
      }
    }
    Object call = arguments.size() == 1 ? arguments.get(0) : arguments;
    Object known = run.kept().get(number, call);
    if (known == null) {
      int begun = run.files().begun();
      Object computed = evaluate(arguments, run);
      known = computed == null ? NULL : computed;
      if (begun == run.files().begun()) {
        run.kept().put(number, call, known);
      }
    }
    return known == NULL ? null : known;
  }

  /** Adds the failing location in the query to the reason, because the call is elsewhere. */
  private Invalid located(Invalid invalid) {
    boolean known = invalid.location().line() > 0;
    SourceLocation place = known ? invalid.location() : value.location();
    return new Invalid(invalid.reason() + ", at " + place, place, invalid.kind(), invalid.cause());
  }

  private Object evaluate(List<Object> arguments, GenerationRun run) {
    Evaluation evaluation = run.evaluation();
    run.enter(this, arguments);
    int bindings = evaluation.bindings();
    try {
      for (int i = 0; i < arguments.size(); i++) {
        evaluation.bind(parameters().get(i).name(), arguments.get(i));
      }
      Object result = value.evaluate(evaluation);
      if (result instanceof Invalid invalid && invalid.limit()) {
        throw run.stop(invalid);
      }
      if (result instanceof Invalid invalid) {
        return located(invalid);
      }
      boolean fits = result == null || accepts.isEmpty() || accepts.get().test(result);
      return fits ? result : misfit(result);
    } catch (VirtualMachineError e) {
      run.calls().keep();
      throw e;
    } finally {
      evaluation.unbindTo(bindings);
      run.leave();
    }
  }

  private Invalid misfit(Object result) {
    ServiceException cause =
        new ServiceException(
            "the Java service of the query '"
                + name()
                + "' gives "
                + ServiceValues.shown(result)
                + ", which is not of type "
                + resultType.getName());
    return new Invalid(cause.getMessage(), value.location(), Invalid.Kind.OTHER, cause);
  }
}
