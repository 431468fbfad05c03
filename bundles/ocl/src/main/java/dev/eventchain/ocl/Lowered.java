package dev.eventchain.ocl;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/**
 * A lowered expression, or the lowered body of a definition. It is complete once it is published to
 * other threads; until then, definitions that call each other can already refer to it.
 */
final class Lowered {

  private Node root;
  private int size;
  private String[] variables = {};
  private boolean whole;
  private List<Lowered> definitions = List.of();

  /**
   * Completes it.
   *
   * @param body the outermost node
   * @param slots how many slots a frame needs
   * @param free the variables whose values come from outside; each one's slot is its index. Null
   *     where a slot is no such variable
   * @param lowered whether nothing is left to Eclipse OCL, definitions aside
   * @param called the definitions that it calls
   */
  void complete(Node body, int slots, String[] free, boolean lowered, List<Lowered> called) {
    root = body;
    size = slots;
    variables = free;
    whole = lowered;
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
      if (variables[i] != null) {
        frame.slots[i] = run.values().get(variables[i]);
      }
    }
    return frame;
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
