package dev.eventchain.ocl.evaluation;

import java.util.List;
import java.util.Set;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;

/**
 * The state of a run that evaluates expressions on a model: the values of the variables, the
 * extents of the classes, limits. For one thread; {@link #fork()} makes another for another thread,
 * which shares the extents. The model must not change meanwhile, but see {@link
 * #withChangingModel}. Made by {@code Evaluations} alone.
 */
public interface Evaluation {

  /** A new evaluation on the same model, with no variables, for another thread. */
  Evaluation fork();

  /**
   * Sets whose time evaluations take from now on; until this is called there is no limit. One that
   * takes more than there is becomes {@link Invalid}.
   */
  Evaluation withBudget(TimeBudget newBudget);

  /** Allows the model to change between two evaluations: nothing is remembered of it. */
  Evaluation withChangingModel();

  /** Gives a variable a value until {@link #unbind}; hides any earlier value. */
  void bind(String name, Object value);

  /** Takes back the latest value of a variable. */
  void unbind(String name);

  /** How many values variables have been given that were not taken back. */
  int bindings();

  /**
   * Replaces a value that a variable was given.
   *
   * @param binding what {@link #bindings} was before {@link #bind}
   */
  void rebind(int binding, Object value);

  /** Takes back all values that variables were given since {@link #bindings} was so many. */
  void unbindTo(int bindings);

  /** Keeps an object for the libraries' use, such as an engine's own state. */
  Evaluation attach(Object state);

  /**
   * The object given to {@link #attach}.
   *
   * @throws ClassCastException if it is not of this type
   */
  <T> T attachment(Class<T> type);

  /** All instances of a class and its subclasses, in the order of the model. Not to be changed. */
  Set<EObject> allInstances(EClass type);

  /**
   * All elements below the objects that this is an evaluation over, these included, each once in
   * the order of the model. Not to be changed.
   */
  List<EObject> elements();

  /** Those of {@link #elements()} that are instances of a class or a subclass. */
  List<EObject> elements(EClass type);

  /** Whether it is time to end. */
  boolean isOutOfTime();

  /** Whether the latest evaluation was stopped because it took too long. */
  boolean ranOutOfTime();
}
