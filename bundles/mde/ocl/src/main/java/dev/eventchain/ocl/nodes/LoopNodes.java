package dev.eventchain.ocl.nodes;

import dev.eventchain.ocl.dialect.OperationLibrary;
import dev.eventchain.ocl.tree.InvalidOrigin;
import dev.eventchain.ocl.values.CollectionOperations;
import dev.eventchain.ocl.values.InsertionOrderedSet;
import dev.eventchain.ocl.values.Limits;
import dev.eventchain.ocl.values.Numbers;
import dev.eventchain.ocl.values.Reachable;
import dev.eventchain.ocl.values.ValueSet;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Set;
import org.eclipse.ocl.expressions.CollectionKind;

/** Iterator expressions. */
public final class LoopNodes {

  private LoopNodes() {}

  /** Iterates over a source; one that is no collection makes the value invalid. */
  private abstract static class Walk extends Node {
    final Node source;

    Walk(Node source) {
      this.source = source;
    }

    @Override
    final Object evaluate(Frame frame) {
      Collection<?> elements = source.elements(frame);
      return elements == null ? INVALID : loop(elements, frame);
    }

    abstract Object loop(Collection<?> elements, Frame frame);
  }

  /** A loop with one variable. */
  abstract static class Loop extends Walk {
    private final int slot;
    private final Node body;

    /**
     * Creates a loop.
     *
     * @param slot the slot of the variable
     */
    Loop(Node source, int slot, Node body) {
      super(source);
      this.slot = slot;
      this.body = body;
    }

    final Node body() {
      return body;
    }

    /** Passes the library calls of the body to a receiver; returns null or invalid. */
    final Object give(
        DefinitionNodes.LibraryCall call, OperationLibrary.Implementation receiver, Frame frame) {
      Collection<?> elements = source.elements(frame);
      if (elements == null) {
        return INVALID;
      }
      for (Object element : elements) {
        frame.run.step();
        frame.slots[slot] = element;
        if (call.give(receiver, frame) == INVALID) {
          return INVALID;
        }
      }
      return null;
    }

    /** Returns the value of the body for an element. */
    final Object body(Object element, Frame frame) {
      frame.run.step();
      frame.slots[slot] = element;
      return body.evaluate(frame);
    }
  }

  /**
   * {@code forAll}, {@code exists}: searches an element whose body has the decisive value, even if
   * the body is invalid for others (OMG OCL 2.4, 7.5.1 and 11.9.1: {@code or} and {@code and} of
   * all bodies).
   */
  public static final class Quantifier extends Loop {
    private final boolean decisive;

    public Quantifier(Node source, int slot, Node body, boolean decisive) {
      super(source, slot, body);
      this.decisive = decisive;
    }

    @Override
    Object loop(Collection<?> elements, Frame frame) {
      Object result = !decisive;
      for (Object element : elements) {
        if (!(body(element, frame) instanceof Boolean value)) {
          result = INVALID;
        } else if (value == decisive) {
          return decisive;
        }
      }
      return result;
    }
  }

  /** {@code forAll} and {@code exists} over all combinations; the first variable varies fastest. */
  public static final class MultiQuantifier extends Walk {
    private final int[] slots;
    private final Node body;
    private final boolean decisive;

    public MultiQuantifier(Node source, int[] slots, Node body, boolean decisive) {
      super(source);
      this.slots = slots;
      this.body = body;
      this.decisive = decisive;
    }

    @Override
    Object loop(Collection<?> elements, Frame frame) {
      return search(elements, slots.length - 1, frame);
    }

    /** Returns the decisive value if it occurs; else invalid if that occurs. */
    private Object search(Collection<?> elements, int variable, Frame frame) {
      Object result = !decisive;
      for (Object element : elements) {
        frame.slots[slots[variable]] = element;
        Object found = variable == 0 ? test(frame) : search(elements, variable - 1, frame);
        if (found == INVALID) {
          result = INVALID;
        } else if (found.equals(decisive)) {
          return found;
        }
      }
      return result;
    }

    private Object test(Frame frame) {
      frame.run.step();
      return body.evaluate(frame) instanceof Boolean value ? value : INVALID;
    }
  }

  /** {@code one}. */
  public static final class One extends Loop {
    public One(Node source, int slot, Node body) {
      super(source, slot, body);
    }

    @Override
    Object loop(Collection<?> elements, Frame frame) {
      boolean found = false;
      for (Object element : elements) {
        if (!(body(element, frame) instanceof Boolean value)) {
          return INVALID;
        } else if (value && found) {
          return false;
        }
        found |= value;
      }
      return found;
    }
  }

  /** {@code any}: null if there is none, as Eclipse OCL has it by default. */
  public static final class Any extends Loop {
    public Any(Node source, int slot, Node body) {
      super(source, slot, body);
    }

    @Override
    Object loop(Collection<?> elements, Frame frame) {
      for (Object element : elements) {
        if (!(body(element, frame) instanceof Boolean value)) {
          return INVALID;
        } else if (value) {
          return element;
        }
      }
      return null;
    }
  }

  /** {@code isUnique}; null counts as a value. */
  public static final class IsUnique extends Loop {
    public IsUnique(Node source, int slot, Node body) {
      super(source, slot, body);
    }

    @Override
    Object loop(Collection<?> elements, Frame frame) {
      Set<Object> seen = new InsertionOrderedSet<>();
      boolean unique = true;
      for (Object element : elements) {
        Object value = body(element, frame);
        if (value == INVALID) {
          return INVALID; // also after two that are equal
        }
        unique &= seen.add(value);
      }
      return unique;
    }
  }

  /** {@code select} and {@code reject}. */
  public static final class Select extends Loop {
    private final CollectionKind kind;
    private final boolean wanted;

    public Select(Node source, int slot, Node body, CollectionKind kind, boolean wanted) {
      super(source, slot, body);
      this.kind = kind;
      this.wanted = wanted;
    }

    @Override
    Object loop(Collection<?> elements, Frame frame) {
      Collection<Object> result = CollectionOperations.create(kind);
      for (Object element : elements) {
        if (!(body(element, frame) instanceof Boolean value)) {
          return INVALID;
        } else if (value == wanted) {
          result.add(element);
        }
      }
      return result;
    }
  }

  /** {@code collect} and {@code collectNested}. */
  public static final class Collect extends Loop {
    private final CollectionKind kind;
    private final boolean flatten;

    public Collect(Node source, int slot, Node body, CollectionKind kind, boolean flatten) {
      super(source, slot, body);
      this.kind = kind;
      this.flatten = flatten;
    }

    /** Returns whether the body is a call of a library's operation. */
    public boolean collectsCalls() {
      return body() instanceof DefinitionNodes.LibraryCall;
    }

    @Override
    Object loop(Collection<?> elements, Frame frame) {
      Collection<Object> result = CollectionOperations.create(kind);
      for (Object element : elements) {
        Object value = body(element, frame);
        if (value == INVALID) {
          return INVALID;
        } else if (flatten && value instanceof Collection<?> several) {
          result.addAll(CollectionOperations.flatten(several));
          Limits.requireElements(result.size());
        } else {
          result.add(value);
        }
      }
      return result;
    }
  }

  /** {@code sortedBy}: stable, by values that are comparable with each other. */
  public static final class SortedBy extends Loop {
    private final boolean distinct;

    /** An element and its sort key. */
    record Keyed(Object element, Object key) {}

    public SortedBy(Node source, int slot, Node body, boolean distinct) {
      super(source, slot, body);
      this.distinct = distinct;
    }

    @Override
    Object loop(Collection<?> elements, Frame frame) {
      List<Keyed> keyed = new ArrayList<>(elements.size());
      for (Object element : elements) {
        keyed.add(new Keyed(element, body(element, frame)));
      }
      return sorted(keyed, distinct, frame.run);
    }

    /** Returns the elements in the order of their keys, or invalid. */
    private static Object sorted(List<Keyed> keyed, boolean distinct, Run run) {
      for (Keyed each : keyed) {
        Object key = each.key();
        if (key == INVALID || !(key instanceof Comparable<?>)) {
          if (key != null && key != INVALID) {
            String shown = InvalidOrigin.described(key);
            run.fail("is " + shown + " for an element, which cannot be ordered", null);
          }
          return INVALID;
        }
      }
      try {
        keyed.sort((one, other) -> compare(one.key(), other.key()));
      } catch (RuntimeException e) {
        run.fail("has values that cannot be compared with each other", null);
        return INVALID;
      }
      Collection<Object> result = distinct ? new ValueSet<>() : new ArrayList<>();
      keyed.forEach(each -> result.add(each.element()));
      return result;
    }

    @SuppressWarnings("unchecked") // checked by the comparison itself, whose exception is caught
    private static int compare(Object one, Object other) {
      return Numbers.isNumber(one) && Numbers.isNumber(other)
          ? Numbers.compare(one, other)
          : ((Comparable<Object>) one).compareTo(other);
    }
  }

  /** {@code closure}. */
  public static final class Closure extends Loop {
    private final boolean ordered;

    public Closure(Node source, int slot, Node body, boolean ordered) {
      super(source, slot, body);
      this.ordered = ordered;
    }

    @Override
    Object loop(Collection<?> elements, Frame frame) {
      Collection<Object> reached =
          Reachable.from(elements, ordered, element -> body(element, frame));
      return reached == null ? INVALID : reached;
    }
  }

  /** {@code iterate}. An invalid accumulator does not end the loop, as in Eclipse OCL. */
  public static final class Iterate extends Walk {
    private final int slot;
    private final int result;
    private final Node start;
    private final Node body;

    public Iterate(Node source, int slot, int result, Node start, Node body) {
      super(source);
      this.slot = slot;
      this.result = result;
      this.start = start;
      this.body = body;
    }

    @Override
    Object loop(Collection<?> elements, Frame frame) {
      frame.slots[result] = start.evaluate(frame);
      for (Object element : elements) {
        frame.run.step();
        frame.slots[slot] = element;
        frame.slots[result] = body.evaluate(frame);
      }
      return frame.slots[result];
    }
  }
}
