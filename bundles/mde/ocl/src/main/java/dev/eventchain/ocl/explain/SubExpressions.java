package dev.eventchain.ocl.explain;

import dev.eventchain.ocl.evaluation.Evaluation;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Function;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.ocl.ecore.Constraint;
import org.eclipse.ocl.ecore.EcoreEnvironment;
import org.eclipse.ocl.expressions.OCLExpression;

/** The parts of an expression, each compiled when first evaluated on its own. Thread-safe. */
public final class SubExpressions {

  /** Evaluates one part. */
  @FunctionalInterface
  public interface Part {

    /** Evaluates the part; the run binds the variables that are declared outside it. */
    Object evaluate(Evaluation run);
  }

  private final EcoreEnvironment environment;
  private final Function<OCLExpression<EClassifier>, Part> compiler;
  private final Map<OCLExpression<EClassifier>, Part> known = new ConcurrentHashMap<>();

  /**
   * Creates the parts.
   *
   * @param environment the environment with the definitions
   * @param compiler compiles a part
   */
  public SubExpressions(
      EcoreEnvironment environment, Function<OCLExpression<EClassifier>, Part> compiler) {
    this.environment = environment;
    this.compiler = compiler;
  }

  /** Returns the definition of an operation or a property; null if there is none. */
  Constraint definition(Object feature) {
    return environment.getDefinition(feature);
  }

  /** Evaluates a part; the run binds the variables that are declared outside it. */
  Object evaluate(OCLExpression<EClassifier> part, Evaluation run) {
    return known.computeIfAbsent(part, compiler).evaluate(run);
  }
}
