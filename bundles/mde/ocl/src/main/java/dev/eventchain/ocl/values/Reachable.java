package dev.eventchain.ocl.values;

import java.util.ArrayDeque;
import java.util.Collection;
import java.util.Deque;
import java.util.Iterator;
import java.util.function.UnaryOperator;

/** The result of {@code closure}. */
public final class Reachable {

  private Reachable() {}

  /**
   * Returns the reachable elements. Depth first like Eclipse OCL, but with its own stack, so that
   * long chains do not need a deep Java stack. As there, the sources are omitted unless they are
   * reached again.
   *
   * @param step returns the successors of an element: a collection, one, or null
   * @return null if a step is invalid
   */
  public static Collection<Object> from(
      Collection<?> sources, boolean ordered, UnaryOperator<Object> step) {
    Collection<Object> result = ordered ? new ValueSet<>() : new InsertionOrderedSet<>();
    for (Object source : sources) {
      if (!addReachable(step.apply(source), result, step)) {
        return null;
      }
    }
    return result;
  }

  /** Adds the elements reachable from one step; returns false if a step is invalid. */
  private static boolean addReachable(
      Object first, Collection<Object> result, UnaryOperator<Object> step) {
    Object next = alongSingle(first, result, step);
    if (!Values.isCollection(next)) {
      return next == null;
    }
    Deque<Iterator<?>> open = new ArrayDeque<>();
    open.push(((Collection<?>) next).iterator());
    while (!open.isEmpty()) {
      if (!open.peek().hasNext()) {
        open.pop();
        continue;
      }
      next = alongSingle(reach(open.peek().next(), result, step), result, step);
      if (Values.isCollection(next)) {
        open.push(((Collection<?>) next).iterator());
      } else if (next != null) {
        return false;
      }
    }
    return true;
  }

  /**
   * Follows steps that lead to one element each.
   *
   * @return the collection at a step to several; null at the end; or invalid
   */
  private static Object alongSingle(
      Object first, Collection<Object> result, UnaryOperator<Object> step) {
    Object next = first;
    while (next != null && next != Values.INVALID && !Values.isCollection(next)) {
      next = reach(next, result, step);
    }
    return next;
  }

  /** Adds an element and returns its successors; null if it was there before. */
  private static Object reach(
      Object element, Collection<Object> result, UnaryOperator<Object> step) {
    if (!result.add(element)) {
      return null;
    }
    Limits.requireElements(result.size());
    return step.apply(element);
  }
}
