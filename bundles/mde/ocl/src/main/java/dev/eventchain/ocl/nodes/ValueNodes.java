package dev.eventchain.ocl.nodes;

import dev.eventchain.ocl.model.ModelAccess;
import dev.eventchain.ocl.values.CollectionOperations;
import dev.eventchain.ocl.values.InsertionOrderedSet;
import dev.eventchain.ocl.values.IntegerRange;
import java.util.Collection;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.ocl.expressions.CollectionKind;

/** Literals, variables and choices. */
public final class ValueNodes {

  private ValueNodes() {}

  /** A literal, or a type. */
  public static final class Constant extends Node {
    private final Object value;

    public Constant(Object value) {
      this.value = value;
    }

    @Override
    Object evaluate(Frame frame) {
      return value;
    }
  }

  /** An operation that is always invalid, but evaluates its source first, a possible origin. */
  public static final class Undefined extends Node {
    private final Node source;

    public Undefined(Node source) {
      this.source = source;
    }

    @Override
    Object evaluate(Frame frame) {
      source.evaluate(frame);
      return INVALID;
    }
  }

  /** A variable. */
  public static final class Slot extends Node {
    private final int index;

    public Slot(int index) {
      this.index = index;
    }

    @Override
    Object evaluate(Frame frame) {
      return frame.slots[index];
    }
  }

  /** {@code let}. */
  public static final class Let extends Node {
    private final int slot;
    private final Node value;
    private final Node body;

    public Let(int slot, Node value, Node body) {
      this.slot = slot;
      this.value = value;
      this.body = body;
    }

    @Override
    Object evaluate(Frame frame) {
      frame.slots[slot] = value.evaluate(frame);
      return body.evaluate(frame);
    }

    @Override
    Object read(Frame frame) {
      frame.slots[slot] = value.evaluate(frame);
      return body.read(frame);
    }
  }

  /** {@code if}. */
  public static final class Choice extends Node {
    private final Node condition;
    private final Node then;
    private final Node otherwise;

    public Choice(Node condition, Node then, Node otherwise) {
      this.condition = condition;
      this.then = then;
      this.otherwise = otherwise;
    }

    @Override
    Object evaluate(Frame frame) {
      return condition.evaluate(frame) instanceof Boolean holds
          ? (holds ? then : otherwise).evaluate(frame)
          : INVALID;
    }

    @Override
    Object read(Frame frame) {
      return condition.evaluate(frame) instanceof Boolean holds
          ? (holds ? then : otherwise).read(frame)
          : INVALID;
    }
  }

  /** The implicit set of a single value before an arrow; empty for null. */
  public static final class ImplicitSet extends Node {
    private final Node item;

    public ImplicitSet(Node item) {
      this.item = item;
    }

    public Node item() {
      return item;
    }

    @Override
    Object evaluate(Frame frame) {
      Object value = item.evaluate(frame);
      return value == INVALID
          ? INVALID
          : new InsertionOrderedSet<>(value == null ? List.of() : Collections.singletonList(value));
    }

    @Override
    Object read(Frame frame) {
      Object value = item.evaluate(frame);
      if (value == null) {
        return Collections.emptyList(); // List.of() does not accept null
      }
      return value == INVALID ? INVALID : Collections.singletonList(value);
    }
  }

  /** A literal of a collection. */
  public static final class CollectionLiteral extends Node {

    /** Elements of the literal. */
    public interface Part {
      /** Adds the elements; returns false if the literal is invalid. */
      boolean addTo(Collection<Object> result, Frame frame);
    }

    private final CollectionKind kind;
    private final Part[] parts;

    public CollectionLiteral(CollectionKind kind, Part[] parts) {
      this.kind = kind;
      this.parts = parts;
    }

    @Override
    Object evaluate(Frame frame) {
      Collection<Object> result = CollectionOperations.create(kind);
      for (Part part : parts) {
        if (!part.addTo(result, frame)) {
          return INVALID;
        }
      }
      return result;
    }
  }

  /** A single element of a literal. */
  public record Item(Node item) implements CollectionLiteral.Part {
    @Override
    public boolean addTo(Collection<Object> result, Frame frame) {
      Object value = item.evaluate(frame);
      result.add(value);
      return value != Node.INVALID;
    }
  }

  /** {@code first..last} next to other parts, or in a set or bag; nothing if either is null. */
  public record Range(Node first, Node last) implements CollectionLiteral.Part {
    @Override
    public boolean addTo(Collection<Object> result, Frame frame) {
      Object from = first.evaluate(frame);
      Object to = last.evaluate(frame);
      if (!isBound(from) || !isBound(to)) {
        return false;
      }
      if (from != null && to != null) {
        addRange(((Number) from).longValue(), ((Number) to).longValue(), result, frame.run);
      }
      return true;
    }

    static boolean isBound(Object value) {
      return value == null || value instanceof Integer || value instanceof Long;
    }

    /** Adds the integers of a range. */
    static void addRange(long from, long to, Collection<Object> result, Run run) {
      IntegerRange range = IntegerRange.between(from, to);
      for (Object each : range) {
        run.step();
        result.add(each);
      }
    }
  }

  /** {@code Sequence{first..last}}; if either is null, it is the one element, as in Eclipse OCL. */
  public static final class SequenceRange extends Node {
    private final Node first;
    private final Node last;

    public SequenceRange(Node first, Node last) {
      this.first = first;
      this.last = last;
    }

    @Override
    Object evaluate(Frame frame) {
      Object from = first.evaluate(frame);
      if (from == null) {
        return listOfNull();
      } else if (!Range.isBound(from)) {
        return INVALID;
      } else {
        Object to = last.evaluate(frame);
        if (to == null) {
          return listOfNull();
        }
        return Range.isBound(to)
            ? IntegerRange.between(((Number) from).longValue(), ((Number) to).longValue())
            : INVALID;
      }
    }

    private static Object listOfNull() {
      List<Object> result = new java.util.ArrayList<>();
      result.add(null);
      return result;
    }
  }

  /** A literal of a tuple. */
  public static final class TupleLiteral extends GuardedNode {
    private final ModelAccess environment;
    private final EClassifier type;
    private final EStructuralFeature[] names;
    private final Node[] values;

    public TupleLiteral(
        ModelAccess environment, EClassifier type, EStructuralFeature[] names, Node[] values) {
      this.environment = environment;
      this.type = type;
      this.names = names;
      this.values = values;
    }

    @Override
    Object compute(Frame frame) {
      Map<EStructuralFeature, Object> parts = new HashMap<>();
      for (int i = 0; i < names.length; i++) {
        parts.put(names[i], values[i].evaluate(frame));
      }
      return environment.createTuple(type, parts);
    }
  }
}
