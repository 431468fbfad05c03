package dev.eventchain.ocl;

import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;

/**
 * The state of a run that evaluates expressions on a model: the values of the variables, the
 * extents of the classes, limits. For one thread; {@link #fork()} makes another for another thread,
 * which shares the extents. The model must not change meanwhile, but see {@link
 * #withChangingModel}.
 */
public final class Evaluation {

  /** Deep enough for definitions that follow a chain of a thousand elements. */
  private static final int DEEPEST_RECURSION = 2000;

  private static final int STEPS_BETWEEN_LOOKS_AT_THE_CLOCK = 1024;

  private final Extents extents;
  private final ValueStack values = new ValueStack();
  private final Map<String, Matcher> matchers = new MatcherCache();
  private final Map<KeyedElements, KeyIndex> indexes = new HashMap<>();
  private boolean modelChanges;
  private Object attachment;
  private TimeBudget budget;
  private int steps;
  private int running;
  private int depth;
  private boolean outOfTime;
  private InvalidOrigin origin;
  private Failure failure = Failure.NONE;

  private Evaluation(Extents extents) {
    this.extents = extents;
  }

  /**
   * An evaluation on the models that these objects belong to.
   *
   * @param objects some objects of each model; the extent of a class covers the whole resource set
   *     of each, or the tree it is in if it has no resource
   */
  public static Evaluation over(Collection<? extends EObject> objects) {
    return new Evaluation(new Extents(objects));
  }

  /** A new evaluation on the same model, with no variables, for another thread. */
  public Evaluation fork() {
    Evaluation fork = new Evaluation(extents);
    fork.attachment = attachment;
    fork.modelChanges = modelChanges;
    fork.budget = budget;
    return fork;
  }

  /**
   * Sets whose time evaluations take from now on; until this is called there is no limit. One that
   * takes more than there is becomes {@link Invalid}.
   */
  public Evaluation withBudget(TimeBudget newBudget) {
    budget = newBudget;
    return this;
  }

  /** Allows the model to change between two evaluations: nothing is remembered of it. */
  public Evaluation withChangingModel() {
    modelChanges = true;
    return this;
  }

  /**
   * The index of the elements of a loop, kept until the loop is about others; null if there may be
   * none.
   */
  KeyIndex index(KeyedElements loop, Collection<?> elements) {
    if (modelChanges) {
      return null;
    }
    KeyIndex known = indexes.get(loop);
    if (known == null || !known.isOf(elements)) {
      known = new KeyIndex(elements);
      indexes.put(loop, known);
    }
    return known;
  }

  /** Gives a variable a value until {@link #unbind}; hides any earlier value. */
  public void bind(String name, Object value) {
    values.push(name, Numbers.normal(value));
  }

  /** Takes back the latest value of a variable. */
  public void unbind(String name) {
    values.remove(name);
  }

  /** How many values variables have been given that were not taken back. */
  public int bindings() {
    return values.size();
  }

  /**
   * Replaces a value that a variable was given.
   *
   * @param binding what {@link #bindings} was before {@link #bind}
   */
  public void rebind(int binding, Object value) {
    values.set(binding, Numbers.normal(value));
  }

  /** Takes back all values that variables were given since {@link #bindings} was so many. */
  public void unbindTo(int bindings) {
    values.truncate(bindings);
  }

  /** Keeps an object for the libraries' use, such as an engine's own state. */
  public Evaluation attach(Object state) {
    attachment = state;
    return this;
  }

  /**
   * The object given to {@link #attach}.
   *
   * @throws ClassCastException if it is not of this type
   */
  public <T> T attachment(Class<T> type) {
    return type.cast(attachment);
  }

  /** All instances of a class and its subclasses, in the order of the model. Not to be changed. */
  public Set<EObject> allInstances(EClass type) {
    return extents.get(type);
  }

  /**
   * All elements below the objects that this is an evaluation over, these included, each once in
   * the order of the model. Not to be changed.
   */
  public List<EObject> elements() {
    return extents.below().all();
  }

  /** Those of {@link #elements()} that are instances of a class or a subclass. */
  public List<EObject> elements(EClass type) {
    return extents.below().instancesOf(type);
  }

  ValueStack values() {
    return values;
  }

  /** The regular expressions that were used last, which are expensive to compile. */
  Map<String, Matcher> matchers() {
    return matchers;
  }

  /** Starts an evaluation and says whether it is not inside another one. */
  boolean begin() {
    boolean outermost = running++ == 0;
    if (outermost) {
      depth = 0;
      outOfTime = false;
    }
    origin = null;
    return outermost;
  }

  void end() {
    running--;
  }

  /** Notes that one more node of an expression is about to be evaluated. */
  void step() {
    if (++steps >= STEPS_BETWEEN_LOOKS_AT_THE_CLOCK) {
      steps = 0;
      String shortage = shortage();
      if (!shortage.isEmpty()) {
        outOfTime = true;
        throw new Halted(shortage, Invalid.Kind.COST);
      }
    }
  }

  private String shortage() {
    if (Thread.currentThread().isInterrupted()) {
      return "it was interrupted";
    }
    return budget == null ? "" : budget.shortage();
  }

  /** Whether it is time to end. */
  public boolean isOutOfTime() {
    return !shortage().isEmpty();
  }

  /** Whether the latest evaluation was stopped because it took too long. */
  public boolean ranOutOfTime() {
    return outOfTime;
  }

  /** Notes that a definition is about to be evaluated. */
  void enterDefinition() {
    if (++depth > DEEPEST_RECURSION) {
      throw new Halted(
          "it recurses endlessly, or more than " + DEEPEST_RECURSION + " calls deep",
          Invalid.Kind.RECURSION);
    }
  }

  void leaveDefinition() {
    depth--;
  }

  InvalidOrigin origin() {
    return origin;
  }

  void setOrigin(InvalidOrigin origin) {
    this.origin = origin;
  }

  /** Keeps what was said of a failure until {@link #takeFailure}. */
  void fail(String detail, RuntimeException cause) {
    failure = new Failure(detail, cause);
  }

  /** As {@link #fail(String, RuntimeException)}, in the words of an exception. */
  void fail(RuntimeException cause) {
    String message = cause.getMessage();
    String words = message == null ? "it cannot be evaluated" : message;
    fail(words.lines().findFirst().orElse(""), cause);
  }

  Failure takeFailure() {
    Failure taken = failure;
    failure = Failure.NONE;
    return taken;
  }

  /**
   * Why the latest operation of Java code or of a library gave no value.
   *
   * @param detail what was said; empty if nothing
   * @param cause the exception by which it was said; null if there was none
   */
  record Failure(String detail, RuntimeException cause) {
    static final Failure NONE = new Failure("", null);
  }

  private static final class MatcherCache extends LinkedHashMap<String, Matcher> {
    private static final long serialVersionUID = 1L;
    private static final int CAPACITY = 64;

    @Override
    protected boolean removeEldestEntry(Map.Entry<String, Matcher> eldest) {
      return size() > CAPACITY;
    }
  }
}
