package dev.eventchain.ocl.nodes;

import dev.eventchain.ocl.evaluation.Evaluation;
import dev.eventchain.ocl.evaluation.Invalid;
import dev.eventchain.ocl.evaluation.TimeBudget;
import dev.eventchain.ocl.model.Extents;
import dev.eventchain.ocl.tree.InvalidOrigin;
import dev.eventchain.ocl.values.Halted;
import dev.eventchain.ocl.values.KeyIndex;
import dev.eventchain.ocl.values.Numbers;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;

/**
 * The state of an evaluation for nodes: besides the public one, the cost so far and the origin of
 * the latest invalid value.
 */
public final class Run implements Evaluation {

  /** Deep enough for definitions that follow a chain of a thousand elements. */
  private static final int DEEPEST_RECURSION = 2000;

  private static final Object NULL = new Object();

  private static final int STEPS_BETWEEN_LOOKS_AT_THE_CLOCK = 1024;

  private final Extents extents;
  private final ValueStack values = new ValueStack();
  private final Map<String, Matcher> matchers = new MatcherCache();
  private final Map<KeyedElements, KeyIndex> indexes = new HashMap<>();

  /** Null values have the marker {@link #NULL}. */
  private final Map<KeptValue, Object> kept = new HashMap<>();

  /** The origins of invalid ones among them, as far as they were traced. */
  private final Map<KeptValue, InvalidOrigin> origins = new HashMap<>();

  private boolean modelChanges;
  private Object attachment;
  private TimeBudget budget;
  private int steps;
  private int running;
  private int depth;
  private boolean outOfTime;
  private InvalidOrigin origin;
  private Failure failure = Failure.NONE;

  private Run(Extents extents) {
    this.extents = extents;
  }

  /** Returns a run on the models of some objects. */
  public static Run over(Collection<? extends EObject> objects) {
    return new Run(new Extents(objects));
  }

  @Override
  public Run fork() {
    Run fork = new Run(extents);
    fork.attachment = attachment;
    fork.modelChanges = modelChanges;
    fork.budget = budget;
    return fork;
  }

  @Override
  public Run withBudget(TimeBudget newBudget) {
    budget = newBudget;
    return this;
  }

  @Override
  public Run withChangingModel() {
    modelChanges = true;
    return this;
  }

  /**
   * Returns the index of the elements of a loop, cached until the loop has others; null if none is
   * allowed.
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

  /**
   * Returns a value that is the same for all elements, computed when first asked for; an invalid
   * one with its origin. It is computed each time if the model may change.
   */
  Object keptValue(KeptValue node, Supplier<Object> value) {
    Object known = kept.get(node);
    if (known == null) {
      known = value.get();
      if (!modelChanges) {
        kept.put(node, known == null ? NULL : known);
        if (known == Node.INVALID) {
          origins.put(node, origin);
        }
      }
    } else if (known == Node.INVALID) {
      origin = origins.get(node);
    }
    return known == NULL ? null : known;
  }

  @Override
  public void bind(String name, Object value) {
    values.push(name, Numbers.normal(value));
  }

  @Override
  public void unbind(String name) {
    values.remove(name);
  }

  @Override
  public int bindings() {
    return values.size();
  }

  @Override
  public void rebind(int binding, Object value) {
    values.set(binding, Numbers.normal(value));
  }

  @Override
  public void unbindTo(int bindings) {
    values.truncate(bindings);
  }

  @Override
  public Run attach(Object state) {
    attachment = state;
    return this;
  }

  @Override
  public <T> T attachment(Class<T> type) {
    return type.cast(attachment);
  }

  @Override
  public Set<EObject> allInstances(EClass type) {
    return extents.get(type);
  }

  @Override
  public List<EObject> elements() {
    return extents.below().all();
  }

  @Override
  public List<EObject> elements(EClass type) {
    return extents.below().instancesOf(type);
  }

  public ValueStack values() {
    return values;
  }

  /** Returns the cache of recent regular expressions, which are expensive to compile. */
  Map<String, Matcher> matchers() {
    return matchers;
  }

  /** Starts an evaluation; returns whether it is an outermost one. */
  public boolean begin() {
    boolean outermost = running++ == 0;
    if (outermost) {
      depth = 0;
      outOfTime = false;
    }
    origin = null;
    return outermost;
  }

  public void end() {
    running--;
  }

  /** Counts the evaluation of a node. */
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

  @Override
  public boolean isOutOfTime() {
    return !shortage().isEmpty();
  }

  @Override
  public boolean ranOutOfTime() {
    return outOfTime;
  }

  /** Counts the entry into a definition. */
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

  public InvalidOrigin origin() {
    return origin;
  }

  public void setOrigin(InvalidOrigin origin) {
    this.origin = origin;
  }

  /** Stores the details of a failure until {@link #takeFailure}. */
  void fail(String detail, RuntimeException cause) {
    failure = new Failure(detail, cause);
  }

  /** As {@link #fail(String, RuntimeException)}, with the message of an exception. */
  void fail(RuntimeException cause) {
    String message = cause.getMessage();
    String words = message == null ? "it cannot be evaluated" : message;
    fail(words.lines().findFirst().orElse(""), cause);
  }

  public Failure takeFailure() {
    Failure taken = failure;
    failure = Failure.NONE;
    return taken;
  }

  /**
   * The failure of the latest operation of Java code or of a library.
   *
   * @param detail the message; empty if there is none
   * @param cause the exception; null if there is none
   */
  public record Failure(String detail, RuntimeException cause) {
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
