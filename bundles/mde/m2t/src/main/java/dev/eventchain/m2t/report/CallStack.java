package dev.eventchain.m2t.report;

import dev.eventchain.ocl.Expression;
import dev.eventchain.ocl.evaluation.Evaluation;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Collections;
import java.util.Comparator;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.impl.BasicEObjectImpl;

/** Stack of the active calls and loops of a run, with their values of self. */
public final class CallStack {

  private static final int CALLS_SHOWN = 8;

  /** Number of innermost calls kept for findings, enough to name a cycle of calls. */
  private static final int CALLS_KEPT = 64;

  /** Number of characters with about the memory of an element of a collection. */
  private static final int ELEMENT_WEIGHT = 8;

  /** A call with the calling expression, which is null for the first call. */
  private record Frame(Called called, List<Object> arguments, Expression caller, long weight) {}

  private final Evaluation evaluation;
  private final Deque<Frame> frames = new ArrayDeque<>();
  private long weight;
  private Object[] selves = new Object[32];
  private int selfCount;

  /**
   * The innermost calls at the time of a stack overflow; empty until then. The depth of an overflow
   * differs between runs, so findings must not depend on the last call.
   */
  private List<Frame> kept = List.of();

  private EObject keptElement;
  private int keptDepth;

  public CallStack(Evaluation evaluation) {
    this.evaluation = evaluation;
  }

  /** Returns the depth of nested calls. */
  public int depth() {
    return frames.size();
  }

  /**
   * Begins a call.
   *
   * @param caller the calling expression; null if there is none
   */
  public void enter(Called called, List<Object> arguments, Expression caller) {
    Frame frame = new Frame(called, arguments, caller, weightOf(arguments));
    frames.push(frame);
    weight += frame.weight();
    pushSelf(arguments.isEmpty() || arguments.get(0) == null ? "" : arguments.get(0));
  }

  public void leave() {
    weight -= frames.pop().weight();
    selfCount--;
  }

  /** Returns the approximate memory of the arguments of all calls, in characters. */
  public long weight() {
    return weight;
  }

  private static long weightOf(List<Object> arguments) {
    long sum = 0;
    for (Object argument : arguments) {
      if (argument instanceof String text) {
        sum += text.length();
      } else if (!(argument instanceof BasicEObjectImpl)
          && argument instanceof Collection<?> elements) {
        sum += (long) elements.size() * ELEMENT_WEIGHT;
      }
    }
    return sum;
  }

  /**
   * Keeps the active calls at a stack overflow, where there is no room to report it. Later calls of
   * this method while the stack unwinds have no effect.
   */
  public void keep() {
    if (!kept.isEmpty()) {
      return;
    }
    List<Frame> latest = new ArrayList<>(CALLS_KEPT);
    for (Frame frame : frames) {
      if (latest.size() == CALLS_KEPT) {
        break;
      }
      latest.add(frame);
    }
    keptElement = outermostElement();
    keptDepth = frames.size();
    kept = latest;
  }

  /** Returns the depth of calls at the stack overflow; 0 without one. */
  public int keptDepth() {
    return keptDepth;
  }

  /** Returns the callable whose recursion overflowed the stack; empty without an overflow. */
  public Optional<Called> tooDeep() {
    return kept.stream()
        .map(Frame::called)
        .min(Comparator.comparing(called -> called.place().location()));
  }

  /** Returns the arguments of the current call. */
  public List<Object> arguments() {
    return frames.element().arguments();
  }

  /** Allocates the variables of a loop and returns their position; {@link #nextItem} sets them. */
  public int enterLoop(Optional<String> variable) {
    int place = evaluation.bindings();
    evaluation.bind("self", null);
    evaluation.bind("i", null);
    if (variable.isPresent()) {
      evaluation.bind(variable.get(), null);
    }
    pushSelf("");
    return place;
  }

  /** Sets the variables of a loop to its next item. */
  public void nextItem(int place, Object item, int index, Optional<String> variable) {
    evaluation.rebind(place, item);
    evaluation.rebind(place + 1, index);
    if (variable.isPresent()) {
      evaluation.rebind(place + 2, item);
    }
    selves[selfCount - 1] = item == null ? "" : item;
  }

  /** Skips an item of a loop that no expression sees. */
  public void skipItem() {
    selves[selfCount - 1] = "";
  }

  public void leaveLoop(int place) {
    selfCount--;
    evaluation.unbindTo(place);
  }

  private void pushSelf(Object self) {
    if (selfCount == selves.length) {
      selves = Arrays.copyOf(selves, selfCount * 2);
    }
    selves[selfCount++] = self;
  }

  /** Returns the values of self around the current expression, innermost first. */
  public List<Object> selves() {
    List<Object> found = new ArrayList<>(Arrays.asList(selves).subList(0, selfCount));
    Collections.reverse(found);
    return found;
  }

  private EObject outermostElement() {
    for (int i = 0; i < selfCount; i++) {
      if (selves[i] instanceof EObject element) {
        return element;
      }
    }
    return null;
  }

  /**
   * Returns the innermost self that is a model element, or the outermost after a stack overflow;
   * null if there is none.
   */
  public EObject element() {
    if (!kept.isEmpty()) {
      return keptElement;
    }
    for (int i = selfCount - 1; i >= 0; i--) {
      if (selves[i] instanceof EObject element) {
        return element;
      }
    }
    return null;
  }

  /** Returns the distinct innermost calls as text; empty if there are none. */
  String shown() {
    Set<String> calls = kept.isEmpty() ? new LinkedHashSet<>() : new TreeSet<>();
    for (Frame frame : kept.isEmpty() ? frames : kept) {
      if (frame.caller() != null && (calls.size() < CALLS_SHOWN || !kept.isEmpty())) {
        calls.add("'" + frame.called().name() + "' called at " + frame.caller().location());
      }
    }
    String first = calls.stream().limit(CALLS_SHOWN).collect(Collectors.joining(", "));
    return first.isEmpty() ? "" : "In " + first + ".";
  }
}
