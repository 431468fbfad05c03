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
import java.util.regex.Matcher;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;

/**
 * The state of an evaluation as nodes see it: besides what callers see, the cost so far and why the
 * latest value is invalid.
 */
public final class Run implements Evaluation {

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

  private Run(Extents extents) {
    this.extents = extents;
  }

  /** A run on the models that these objects belong to. */
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

  /** The regular expressions that were used last, which are expensive to compile. */
  Map<String, Matcher> matchers() {
    return matchers;
  }

  /** Starts an evaluation and says whether it is not inside another one. */
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

  @Override
  public boolean isOutOfTime() {
    return !shortage().isEmpty();
  }

  @Override
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

  public InvalidOrigin origin() {
    return origin;
  }

  public void setOrigin(InvalidOrigin origin) {
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

  public Failure takeFailure() {
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
