package dev.eventchain.ocl.nodes;

import dev.eventchain.ocl.model.ModelAccess;
import dev.eventchain.ocl.model.TypeTest;
import dev.eventchain.ocl.values.CollectionCalls;
import dev.eventchain.ocl.values.CollectionOperations;
import dev.eventchain.ocl.values.ValueSet;
import dev.eventchain.ocl.values.Values;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import org.eclipse.emf.common.util.EList;
import org.eclipse.ocl.expressions.CollectionKind;
import org.eclipse.ocl.util.CollectionUtil;
import org.eclipse.ocl.utilities.PredefinedType;

/** Operations of collections that make other ones, or lead to an element by its position. */
public final class CollectionNodes {

  private CollectionNodes() {}

  /** The conversions {@code asSet()} and so on, and {@code flatten()}. */
  public static final class Conversion extends GuardedNode {
    private final int code;
    private final Node source;

    public Conversion(int code, Node source) {
      this.code = code;
      this.source = source;
    }

    public static boolean has(int code) {
      return switch (code) {
        case PredefinedType.AS_SET,
            PredefinedType.AS_BAG,
            PredefinedType.AS_SEQUENCE,
            PredefinedType.AS_ORDERED_SET,
            PredefinedType.FLATTEN ->
            true;
        default -> false;
      };
    }

    @Override
    Object compute(Frame frame) {
      // Flattening depends on the kind of the source.
      Object value = code == PredefinedType.FLATTEN ? source.evaluate(frame) : source.read(frame);
      if (!(value instanceof Collection<?> elements)) {
        return INVALID;
      }
      return switch (code) {
        case PredefinedType.AS_SEQUENCE ->
            elements instanceof List<?> && !(elements instanceof EList<?>)
                ? elements
                : new ArrayList<>(elements);
        case PredefinedType.AS_ORDERED_SET ->
            elements instanceof ValueSet<?> ? elements : new ValueSet<>(elements);
        default -> CollectionCalls.unary(code, elements);
      };
    }
  }

  /** An operation with one argument that is a collection, too. */
  public static final class Pair extends GuardedNode {
    private final int code;
    private final Node source;
    private final Node argument;

    public Pair(int code, Node source, Node argument) {
      this.code = code;
      this.source = source;
      this.argument = argument;
    }

    public static boolean has(int code) {
      return switch (code) {
        case PredefinedType.INCLUDES_ALL,
            PredefinedType.EXCLUDES_ALL,
            PredefinedType.UNION,
            PredefinedType.INTERSECTION,
            PredefinedType.MINUS,
            PredefinedType.SYMMETRIC_DIFFERENCE ->
            true;
        default -> false;
      };
    }

    @Override
    Object compute(Frame frame) {
      CollectionKind one = source.kindOfElements();
      CollectionKind other = argument.kindOfElements();
      if (code == PredefinedType.UNION && one != null && other != null) {
        Collection<?> elements = source.elements(frame);
        Collection<?> others = elements == null ? null : argument.elements(frame);
        return others == null ? INVALID : CollectionOperations.union(elements, one, others, other);
      }
      if (!(source.evaluate(frame) instanceof Collection<?> elements)
          || !(argument.evaluate(frame) instanceof Collection<?> others)) {
        return INVALID;
      }
      return switch (code) {
        case PredefinedType.INCLUDES_ALL -> Values.containsAll(elements, others);
        case PredefinedType.EXCLUDES_ALL -> Values.containsNone(elements, others);
        default -> CollectionCalls.binary(code, elements, others);
      };
    }
  }

  /** An operation with one argument that is an element or an index. */
  public static final class WithElement extends GuardedNode {
    private final int code;
    private final Node source;
    private final Node argument;

    public WithElement(int code, Node source, Node argument) {
      this.code = code;
      this.source = source;
      this.argument = argument;
    }

    public static boolean has(int code) {
      return switch (code) {
        case PredefinedType.COUNT,
            PredefinedType.INCLUDING,
            PredefinedType.EXCLUDING,
            PredefinedType.AT,
            PredefinedType.INDEX_OF,
            PredefinedType.PREPEND,
            PredefinedType.APPEND ->
            true;
        default -> false;
      };
    }

    @Override
    Object compute(Frame frame) {
      // The position of an element does not depend on the kind of the collection.
      boolean only = code == PredefinedType.INDEX_OF && source.kindOfElements() != null;
      Object given = only ? source.read(frame) : source.evaluate(frame);
      if (!(given instanceof Collection<?> elements)) {
        return INVALID;
      }
      Object value = argument.evaluate(frame);
      return value == INVALID ? INVALID : compute(elements, value);
    }

    @SuppressWarnings("unchecked") // Eclipse OCL copies the collection before it adds an element
    private Object compute(Collection<?> elements, Object value) {
      return switch (code) {
        case PredefinedType.COUNT -> Values.count(elements, value);
        case PredefinedType.INCLUDING -> CollectionOperations.including(elements, value);
        case PredefinedType.EXCLUDING -> CollectionOperations.excluding(elements, value);
        case PredefinedType.AT ->
            value instanceof Integer index ? CollectionUtil.at(elements, index) : INVALID;
        case PredefinedType.INDEX_OF -> indexOf(elements, value);
        case PredefinedType.PREPEND ->
            CollectionOperations.distinct(
                CollectionUtil.prepend((Collection<Object>) elements, value));
        default ->
            CollectionOperations.distinct(
                CollectionUtil.append((Collection<Object>) elements, value));
      };
    }
  }

  private static Object indexOf(Collection<?> elements, Object value) {
    int index = Values.indexOf(elements, value);
    return index == 0 ? Node.INVALID : (Object) index;
  }

  /** An operation with two arguments: {@code insertAt}, {@code subSequence} and the like. */
  public static final class Positional extends GuardedNode {
    private final int code;
    private final Node source;
    private final Node first;
    private final Node second;

    public Positional(int code, Node source, Node first, Node second) {
      this.code = code;
      this.source = source;
      this.first = first;
      this.second = second;
    }

    public static boolean has(int code) {
      return code == PredefinedType.INSERT_AT
          || code == PredefinedType.SUB_SEQUENCE
          || code == PredefinedType.SUB_ORDERED_SET;
    }

    @Override
    @SuppressWarnings("unchecked") // Eclipse OCL copies the collection before it adds an element
    Object compute(Frame frame) {
      if (!(source.evaluate(frame) instanceof Collection<?> elements)) {
        return INVALID;
      }
      Object one = first.evaluate(frame);
      Object two = second.evaluate(frame);
      if (!(one instanceof Integer index) || two == INVALID) {
        return INVALID;
      } else if (code == PredefinedType.INSERT_AT) {
        return CollectionOperations.distinct(
            CollectionUtil.insertAt((Collection<Object>) elements, index, two));
      } else if (!(two instanceof Integer end)) {
        return INVALID;
      } else {
        return code == PredefinedType.SUB_SEQUENCE
            ? CollectionUtil.subSequence(elements, index, end)
            : CollectionOperations.distinct(CollectionUtil.subOrderedSet(elements, index, end));
      }
    }
  }

  /** {@code product}. */
  public static final class ProductNode extends GuardedNode {
    private final Node source;
    private final Node argument;
    private final Product product;
    private final ModelAccess environment;

    public ProductNode(Node source, Node argument, Product product, ModelAccess environment) {
      this.source = source;
      this.argument = argument;
      this.product = product;
      this.environment = environment;
    }

    @Override
    Object compute(Frame frame) {
      return source.evaluate(frame) instanceof Collection<?> elements
              && argument.evaluate(frame) instanceof Collection<?> others
          ? product.make(elements, others, environment, frame.run)
          : INVALID;
    }
  }

  /** {@code selectByKind} and {@code selectByType}. */
  public static final class SelectByType extends GuardedNode {
    private final Node source;
    private final TypeTest test;

    public SelectByType(Node source, TypeTest test) {
      this.source = source;
      this.test = test;
    }

    @Override
    Object compute(Frame frame) {
      if (!(source.evaluate(frame) instanceof Collection<?> elements)) {
        return INVALID;
      }
      Collection<Object> result =
          CollectionOperations.create(CollectionOperations.kindOf(elements));
      for (Object element : elements) {
        if (test.selects(element)) {
          result.add(element);
        }
      }
      return result;
    }
  }
}
