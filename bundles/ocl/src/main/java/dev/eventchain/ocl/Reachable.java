package dev.eventchain.ocl;

import java.util.ArrayDeque;
import java.util.Collection;
import java.util.Deque;
import java.util.Iterator;
import java.util.function.UnaryOperator;

/** What {@code closure} gives. */
final class Reachable {

  private Reachable() {}

  /**
   * What can be reached. Depth first, like Eclipse OCL, but with a stack of its own, so that a long
   * chain of elements does not need a deep Java stack. As there, the sources themselves are left
   * out unless they are reached again.
   *
   * @param step leads from an element to some others, to one, or to null
   * @return null if a step is invalid
   */
  static Collection<Object> from(
      Collection<?> sources, boolean ordered, UnaryOperator<Object> step) {
    Collection<Object> result = ordered ? new ValueSet<>() : new InsertionOrderedSet<>();
    for (Object source : sources) {
      Object next = step.apply(source);
      if (next == Node.INVALID || !addReachable(next, result, step)) {
        return null;
      }
    }
    return result;
  }

  /** Adds what can be reached from one step; false if a step is invalid. */
  private static boolean addReachable(
      Object first, Collection<Object> result, UnaryOperator<Object> step) {
    Deque<Iterator<?>> open = new ArrayDeque<>();
    open.push(CollectionCalls.elementsOf(first).iterator());
    while (!open.isEmpty()) {
      if (!open.peek().hasNext()) {
        open.pop();
        continue;
      }
      Object element = open.peek().next();
      if (result.add(element)) {
        Limits.requireElements(result.size());
        Object next = step.apply(element);
        if (next == Node.INVALID) {
          return false;
        }
        open.push(CollectionCalls.elementsOf(next).iterator());
      }
    }
    return true;
  }
}
