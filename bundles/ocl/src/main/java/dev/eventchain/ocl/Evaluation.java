package dev.eventchain.ocl;

import java.time.Duration;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.ocl.EvaluationHaltedException;

/**
 * The state of a run that evaluates expressions on a model: the values of the variables, the
 * extents of the classes, limits. For one thread; {@link #fork()} makes another for another thread,
 * which shares the extents. The model must not change meanwhile.
 */
public final class Evaluation {

  /** Deep enough for definitions that follow a chain of a thousand elements. */
  private static final int DEEPEST_RECURSION = 2000;

  private static final int STEPS_BETWEEN_LOOKS_AT_THE_CLOCK = 1024;

  private final Extents extents;
  private final ValueStack values = new ValueStack();
  private final Map<String, Matcher> matchers = new MatcherCache();
  private Object attachment;
  private Duration timeLimit = Duration.ofDays(1);
  private boolean started;
  private long deadline;
  private boolean deadlineIsFixed;
  private int steps;
  private int running;
  private int depth;
  private boolean outOfTime;
  private InvalidOrigin origin;
  private String note = "";

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
    fork.timeLimit = timeLimit;
    fork.attachment = attachment;
    return fork;
  }

  /**
   * Sets how long one {@link Expression#evaluate} may take before it becomes {@link Invalid}; until
   * this is called there is no limit to speak of. Evaluations that a library starts inside another
   * one count as part of that.
   */
  public Evaluation withTimeLimit(Duration limit) {
    timeLimit = limit;
    deadlineIsFixed = false;
    return this;
  }

  /**
   * Sets when all evaluations from now on must have ended, instead of how long each may take.
   *
   * @param nanoTime in the time of {@link System#nanoTime}
   */
  void setDeadline(long nanoTime) {
    deadline = nanoTime;
    deadlineIsFixed = true;
  }

  /** What {@link #setDeadline} was given. */
  long deadline() {
    return deadline;
  }

  /** Gives a variable a value until {@link #unbind}; hides any earlier value. */
  public void bind(String name, Object value) {
    values.push(name, value);
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
    values.set(binding, value);
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

  Extents extents() {
    return extents;
  }

  ValueStack values() {
    return values;
  }

  /** The regular expressions that were used last, which are dear to compile. */
  Map<String, Matcher> matchers() {
    return matchers;
  }

  /** Starts an evaluation and says whether it is not inside another one. */
  boolean begin() {
    boolean outermost = running++ == 0;
    if (outermost) {
      started = deadlineIsFixed;
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
      long now = System.nanoTime();
      if (!started) {
        // Most evaluations are over before their first look at the clock.
        started = true;
        deadline = now + timeLimit.toNanos();
      }
      if (now - deadline >= 0 || Thread.currentThread().isInterrupted()) {
        outOfTime = true;
        throw new EvaluationHaltedException("it takes longer than " + text(timeLimit));
      }
    }
  }

  /** Whether the latest evaluation was stopped because it took too long. */
  boolean ranOutOfTime() {
    return outOfTime;
  }

  /** Notes that a definition is about to be evaluated. */
  void enterDefinition() {
    if (++depth > DEEPEST_RECURSION) {
      throw new EvaluationHaltedException(
          "it recurses without end, or more than " + DEEPEST_RECURSION + " calls deep");
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

  /** Keeps what Java said of a failure until {@link #takeNote}. */
  void note(String text) {
    note = text;
  }

  String takeNote() {
    String taken = note;
    note = "";
    return taken;
  }

  private static String text(Duration duration) {
    return duration.toMillis() % 1000 == 0
        ? duration.toSeconds() + " s"
        : duration.toMillis() + " ms";
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
