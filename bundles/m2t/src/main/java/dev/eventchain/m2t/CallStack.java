package dev.eventchain.m2t;

import dev.eventchain.ocl.Evaluation;
import dev.eventchain.ocl.Expression;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.eclipse.emf.ecore.EObject;

/** The calls and loops that a run is in, and the values of self around them. */
final class CallStack {

  private static final int CALLS_SHOWN = 8;

  /** A call, and the expression it was made by; null for the first. */
  private record Frame(Callable callable, List<Object> arguments, Expression caller) {}

  private final Evaluation evaluation;
  private final Deque<Frame> frames = new ArrayDeque<>();
  private Object[] selves = new Object[32];
  private int selfCount;

  CallStack(Evaluation evaluation) {
    this.evaluation = evaluation;
  }

  /** How many calls there are, one in the other. */
  int depth() {
    return frames.size();
  }

  /**
   * Begins a call.
   *
   * @param caller the expression that makes it; null if there is none
   */
  void enter(Callable callable, List<Object> arguments, Expression caller) {
    frames.push(new Frame(callable, arguments, caller));
    pushSelf(arguments.isEmpty() || arguments.get(0) == null ? "" : arguments.get(0));
  }

  void leave() {
    frames.pop();
    selfCount--;
  }

  /** The arguments of the call at work. */
  List<Object> arguments() {
    return frames.element().arguments();
  }

  /**
   * Makes room for the variables of a loop, and says where; {@link #nextItem} gives them values.
   */
  int enterLoop(Optional<String> variable) {
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
  void nextItem(int place, Object item, int index, Optional<String> variable) {
    evaluation.rebind(place, item);
    evaluation.rebind(place + 1, index);
    if (variable.isPresent()) {
      evaluation.rebind(place + 2, item);
    }
    selves[selfCount - 1] = item == null ? "" : item;
  }

  /** Passes over an item of a loop, of which no expression knows. */
  void skipItem() {
    selves[selfCount - 1] = "";
  }

  void leaveLoop(int place) {
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
  List<Object> selves() {
    List<Object> found = new ArrayList<>(Arrays.asList(selves).subList(0, selfCount));
    Collections.reverse(found);
    return found;
  }

  /** The innermost self that is a model element; null if there is none. */
  EObject element() {
    for (int i = selfCount - 1; i >= 0; i--) {
      if (selves[i] instanceof EObject element) {
        return element;
      }
    }
    return null;
  }

  /** The latest calls for people, each once, from the innermost; empty if there are none. */
  String shown() {
    Set<String> calls = new LinkedHashSet<>();
    for (Frame frame : frames) {
      if (frame.caller() != null && calls.size() < CALLS_SHOWN) {
        calls.add("'" + frame.callable().name() + "' called at " + frame.caller().location());
      }
    }
    return calls.isEmpty() ? "" : "In " + String.join(", ", calls) + ".";
  }
}
