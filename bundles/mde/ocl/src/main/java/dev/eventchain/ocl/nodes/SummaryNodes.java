package dev.eventchain.ocl.nodes;

import dev.eventchain.ocl.values.Numbers;
import dev.eventchain.ocl.values.Values;
import java.util.Collection;
import java.util.List;
import org.eclipse.ocl.util.CollectionUtil;
import org.eclipse.ocl.utilities.PredefinedType;

/** Operations that sum up a collection: its size, what it includes, its largest element. */
public final class SummaryNodes {

  private SummaryNodes() {}

  /** {@code size()}. */
  public static final class Size extends Node {
    private final Node source;

    public Size(Node source) {
      this.source = source;
    }

    @Override
    Object evaluate(Frame frame) {
      Collection<?> elements = source.elements(frame);
      return elements == null ? INVALID : (Object) elements.size();
    }
  }

  /** {@code isEmpty()} and {@code notEmpty()}. */
  public static final class IsEmpty extends Node {
    private final Node source;
    private final boolean wanted;

    public IsEmpty(Node source, boolean wanted) {
      this.source = source;
      this.wanted = wanted;
    }

    @Override
    Object evaluate(Frame frame) {
      Collection<?> elements = source.elements(frame);
      return elements == null ? INVALID : (Object) (elements.isEmpty() == wanted);
    }
  }

  /** {@code x->isEmpty()} and {@code x->notEmpty()} of a single value. */
  public static final class IsAbsent extends Node {
    private final Node item;
    private final boolean wanted;

    public IsAbsent(Node item, boolean wanted) {
      this.item = item;
      this.wanted = wanted;
    }

    @Override
    Object evaluate(Frame frame) {
      Object value = item.evaluate(frame);
      return value == INVALID ? INVALID : (Object) ((value == null) == wanted);
    }
  }

  /** {@code includes} and {@code excludes}. */
  public static final class Includes extends GuardedNode {
    private final Node source;
    private final Node element;
    private final boolean wanted;
    private final boolean integers;

    /** Creates the node; with integers only, equality in OCL is that of Java. */
    public Includes(Node source, Node element, boolean wanted, boolean integers) {
      this.source = source;
      this.element = element;
      this.wanted = wanted;
      this.integers = integers;
    }

    @Override
    Object compute(Frame frame) {
      Collection<?> elements = source.elements(frame);
      if (elements == null) {
        return INVALID;
      }
      Object value = element.evaluate(frame);
      boolean found = integers ? elements.contains(value) : Values.contains(elements, value);
      return value == INVALID ? INVALID : (Object) (found == wanted);
    }
  }

  /** {@code first()}, {@code last()}, {@code max()}, {@code min()} and {@code sum()}. */
  public static final class Aggregate extends GuardedNode {
    private final int code;
    private final Node source;
    private final Object emptySum;

    /**
     * Creates the node.
     *
     * @param emptySum the sum of an empty collections
     */
    public Aggregate(int code, Node source, Object emptySum) {
      this.code = code;
      this.source = source;
      this.emptySum = emptySum;
    }

    public static boolean has(int code) {
      return switch (code) {
        case PredefinedType.FIRST,
            PredefinedType.LAST,
            PredefinedType.MAX,
            PredefinedType.MIN,
            PredefinedType.SUM ->
            true;
        default -> false;
      };
    }

    @Override
    Object compute(Frame frame) {
      Collection<?> elements = source.elements(frame);
      if (elements == null) {
        return INVALID;
      }
      return switch (code) {
        case PredefinedType.FIRST -> elements.isEmpty() ? INVALID : elements.iterator().next();
        case PredefinedType.LAST -> elements.isEmpty() ? INVALID : last(elements);
        case PredefinedType.MAX, PredefinedType.MIN ->
            elements.isEmpty() ? null : combined(elements, code);
        default -> elements.isEmpty() ? emptySum : combined(elements, PredefinedType.PLUS);
      };
    }

    private static Object combined(Collection<?> elements, int operation) {
      Object result = null;
      for (Object element : elements) {
        if (!Numbers.isNumber(element)) {
          return INVALID;
        }
        result = result == null ? element : NumberNodes.binary(operation, result, element);
      }
      return result;
    }

    private static Object last(Collection<?> elements) {
      return elements instanceof List<?> list
          ? list.get(list.size() - 1)
          : CollectionUtil.last(elements);
    }
  }
}
