package dev.eventchain.ocl.evaluation;

import java.util.List;
import java.util.Set;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;

/**
 * The state of a run that evaluates expressions on a model: the values of the variables, the
 * extents of the classes, limits. For one thread; {@link #fork()} returns another for another
 * thread, which shares the extents. The model must not change meanwhile, but see {@link
 * #withChangingModel}. Only {@code Evaluations} creates it.
 */
public interface Evaluation {

  /** Returns a new evaluation on the same model, without variables, for another thread. */
  Evaluation fork();

  /**
   * Sets the time budget of evaluations from now on; there is no limit before. One that exceeds the
   * budget becomes {@link Invalid}.
   */
  Evaluation withBudget(TimeBudget newBudget);

  /** Allows the model to change between two evaluations: nothing is cached. */
  Evaluation withChangingModel();

  /** Binds a variable to a value until {@link #unbind}; hides any earlier value. */
  void bind(String name, Object value);

  /** Removes the latest value of a variable. */
  void unbind(String name);

  /** Returns the number of bindings that have not been removed. */
  int bindings();

  /**
   * Replaces the value of a binding.
   *
   * @param binding the result of {@link #bindings} before {@link #bind}
   */
  void rebind(int binding, Object value);

  /** Removes all bindings since {@link #bindings} had this result. */
  void unbindTo(int bindings);

  /** Stores an object for use by libraries, such as an engine's own state. */
  Evaluation attach(Object state);

  /**
   * Returns the object given to {@link #attach}.
   *
   * @throws ClassCastException if it is not of this type
   */
  <T> T attachment(Class<T> type);

  /** Returns all instances of a class and its subclasses, in model order. Read-only. */
  Set<EObject> allInstances(EClass type);

  /**
   * Returns the objects of this evaluation and all elements below them, each once, in model order.
   * Read-only.
   */
  List<EObject> elements();

  /** Returns those of {@link #elements()} that are instances of a class or a subclass. */
  List<EObject> elements(EClass type);

  /** Returns whether the time is over. */
  boolean isOutOfTime();

  /** Returns whether the latest evaluation was stopped because it took too long. */
  boolean ranOutOfTime();
}
