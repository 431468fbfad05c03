package dev.eventchain.ocl;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;

/**
 * A lowered expression, or the lowered body of a definition. It is complete once it is published to
 * other threads; until then, definitions that call each other can already refer to it.
 */
final class Lowered {

  private Node root;
  private int size;
  private String[] variables = {};
  private int[] variableSlots = {};
  private boolean whole;
  private boolean quick;

  /** Set if the body is a feature of the only variable. */
  private NavigationNodes.Feature feature;

  private List<Lowered> definitions = List.of();

  /**
   * Completes it.
   *
   * @param body the outermost node
   * @param slots for each slot of a frame the variable whose value comes from outside, or null
   * @param lowered whether nothing is left to Eclipse OCL, definitions aside
   * @param called the definitions that it calls
   */
  void complete(Node body, List<String> slots, boolean lowered, List<Lowered> called) {
    root = body;
    size = slots.size();
    variableSlots = IntStream.range(0, size).filter(i -> slots.get(i) != null).toArray();
    variables = IntStream.of(variableSlots).mapToObj(slots::get).toArray(String[]::new);
    whole = lowered;
    if (size == 1 && variables.length == 1) {
      boolean ofVariable =
          body instanceof NavigationNodes.Feature found
              && found.source() instanceof ValueNodes.Slot;
      feature = ofVariable ? (NavigationNodes.Feature) body : null;
      quick = ofVariable || body instanceof ValueNodes.Slot;
    } else {
      quick = body instanceof ValueNodes.Constant;
    }
    definitions = List.copyOf(called);
  }

  Node root() {
    return root;
  }

  int size() {
    return size;
  }

  /** A frame with the values of the variables. */
  Frame frame(Evaluation run) {
    Frame frame = new Frame(run, size);
    for (int i = 0; i < variables.length; i++) {
      frame.slots[variableSlots[i]] = run.values().get(variables[i]);
    }
    return frame;
  }

  /** Whether {@link #quick} can be asked. */
  boolean isQuick() {
    return quick;
  }

  /** The value without a frame, for what most tags of templates hold: {@code x.name}, or a text. */
  Object quick(Evaluation run, boolean read) {
    if (feature != null) {
      return feature.valueOf(run.values().get(variables[0]), read, run);
    }
    return variables.length == 1 ? run.values().get(variables[0]) : root.evaluate(null);
  }

  /** Whether nothing is left to Eclipse OCL's evaluator, also in the definitions it calls. */
  boolean isWhole() {
    Set<Lowered> reached = new LinkedHashSet<>(List.of(this));
    List<Lowered> open = new java.util.ArrayList<>(reached);
    while (!open.isEmpty()) {
      Lowered next = open.remove(open.size() - 1);
      if (!next.whole) {
        return false;
      }
      next.definitions.stream().filter(reached::add).forEach(open::add);
    }
    return true;
  }
}
