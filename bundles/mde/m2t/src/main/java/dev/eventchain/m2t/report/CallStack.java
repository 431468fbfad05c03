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

/** The calls and loops that a run is in, and the values of self around them. */
public final class CallStack {

  private static final int CALLS_SHOWN = 8;

  /** Enough to name all that call each other in turn. */
  private static final int CALLS_KEPT = 64;

  /** How many characters take about as much memory as an element of a collection. */
  private static final int ELEMENT_WEIGHT = 8;

  /** A call, and the expression it was made by; null for the first. */
  private record Frame(Called called, List<Object> arguments, Expression caller, long weight) {}

  private final Evaluation evaluation;
  private final Deque<Frame> frames = new ArrayDeque<>();
  private long weight;
  private Object[] selves = new Object[32];
  private int selfCount;

  /**
   * The calls at work, and the first element, when there was no more room; empty until then. How
   * deep that is differs from run to run, so nothing that is said of it depends on which is last.
   */
  private List<Frame> kept = List.of();

  private EObject keptElement;
  private int keptDepth;

  public CallStack(Evaluation evaluation) {
    this.evaluation = evaluation;
  }

  /** How many calls there are, one in the other. */
  public int depth() {
    return frames.size();
  }

  /**
   * Begins a call.
   *
   * @param caller the expression that makes it; null if there is none
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

  /** About how much memory the arguments of all calls take, in characters. */
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
   * Remembers the calls at work, because there is no room to say here that they are too many. Only
   * the first time counts: the calls that are left on the way out are those that led there.
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

  /** How many calls there were when there was no more room; 0 if there always was. */
  public int keptDepth() {
    return keptDepth;
  }

  /** What calls itself until there was no more room; empty if there always was. */
  public Optional<Called> tooDeep() {
    return kept.stream()
        .map(Frame::called)
        .min(Comparator.comparing(called -> called.place().location()));
  }

  /** The arguments of the call at work. */
  public List<Object> arguments() {
    return frames.element().arguments();
  }

  /**
   * Makes room for the variables of a loop, and says where; {@link #nextItem} gives them values.
   */
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

  /** Goes on with another item of a loop. */
  public void nextItem(int place, Object item, int index, Optional<String> variable) {
    evaluation.rebind(place, item);
    evaluation.rebind(place + 1, index);
    if (variable.isPresent()) {
      evaluation.rebind(place + 2, item);
    }
    selves[selfCount - 1] = item == null ? "" : item;
  }

  /** Passes over an item of a loop, of which no expression knows. */
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

  /** The values of self around the expression at work, from the innermost. */
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
   * The innermost self that is a model element, or the outermost where there was no more room; null
   * if there is none.
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

  /** Calls for people, each once: the latest from the innermost; empty if there are none. */
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
