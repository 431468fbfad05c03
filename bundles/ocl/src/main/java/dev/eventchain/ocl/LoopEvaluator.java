package dev.eventchain.ocl;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Deque;
import java.util.HashSet;
import java.util.Iterator;
import java.util.List;
import java.util.Set;
import java.util.function.UnaryOperator;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EClassifier;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EOperation;
import org.eclipse.emf.ecore.EParameter;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.ocl.EvaluationEnvironment;
import org.eclipse.ocl.expressions.CollectionKind;
import org.eclipse.ocl.expressions.IteratorExp;
import org.eclipse.ocl.types.OrderedSetType;
import org.eclipse.ocl.types.SetType;
import org.eclipse.ocl.utilities.PredefinedType;

/**
 * Evaluates the iterators that make collections, keeping the order of sets and bags, and those that
 * compare values.
 */
final class LoopEvaluator {

  private final Evaluator evaluator;
  private final Object invalid;
  private final EvaluationEnvironment<EClassifier, EOperation, EStructuralFeature, EClass, EObject>
      values;
  private final IteratorExp<EClassifier, EParameter> loop;
  private final String variable;

  LoopEvaluator(Evaluator evaluator, IteratorExp<EClassifier, EParameter> loop) {
    this.evaluator = evaluator;
    this.invalid = evaluator.invalid();
    this.values = evaluator.getEvaluationEnvironment();
    this.loop = loop;
    this.variable = loop.getIterator().get(0).getName();
  }

  Object evaluate(int code, Collection<?> elements) {
    Object sourceType = loop.getSource().getType();
    CollectionKind selected = CollectionOperations.kindOfSelection(sourceType);
    CollectionKind collected = CollectionOperations.kindOfCollection(sourceType);
    return switch (code) {
      case PredefinedType.SELECT -> select(elements, selected, true);
      case PredefinedType.REJECT -> select(elements, selected, false);
      case PredefinedType.COLLECT -> collect(elements, collected, true);
      case PredefinedType.COLLECT_NESTED -> collect(elements, collected, false);
      case PredefinedType.IS_UNIQUE -> isUnique(elements);
      case PredefinedType.FOR_ALL -> decided(elements, false, loop.getIterator().size() - 1);
      case PredefinedType.EXISTS -> decided(elements, true, loop.getIterator().size() - 1);
      case PredefinedType.SORTED_BY -> sortedBy(elements, sourceType);
      default -> closure(elements);
    };
  }

  /** Whether this iterator is evaluated here. */
  static boolean has(int code) {
    return CollectionCalls.makesCollectionByIterating(code)
        || isQuantifier(code)
        || code == PredefinedType.IS_UNIQUE
        || code == PredefinedType.SORTED_BY;
  }

  /** Whether this iterator may have several variables. */
  static boolean isQuantifier(int code) {
    return code == PredefinedType.FOR_ALL || code == PredefinedType.EXISTS;
  }

  /** The decisive value if a body has it; else invalid if one is undefined. */
  private Object decided(Collection<?> elements, boolean decisive, int iterator) {
    Object result = !decisive;
    String name = loop.getIterator().get(iterator).getName();
    values.add(name, null);
    try {
      for (Object element : elements) {
        values.replace(name, element);
        Object value =
            iterator == 0
                ? evaluator.safeVisitExpression(loop.getBody())
                : decided(elements, decisive, iterator - 1);
        if (!(value instanceof Boolean found)) {
          result = invalid;
        } else if (found == decisive) {
          return found;
        }
      }
    } finally {
      values.remove(name);
    }
    return result;
  }

  private Object isUnique(Collection<?> elements) {
    Set<Object> seen = new HashSet<>();
    boolean unique = true;
    values.add(variable, null);
    try {
      for (Object element : elements) {
        Object value = body(element);
        if (value == invalid) {
          return invalid;
        }
        unique &= seen.add(Values.key(value));
      }
    } finally {
      values.remove(variable);
    }
    return unique;
  }

  private Object sortedBy(Collection<?> elements, Object type) {
    List<LoopNodes.SortedBy.Keyed> keyed = new ArrayList<>();
    values.add(variable, null);
    try {
      for (Object element : elements) {
        keyed.add(new LoopNodes.SortedBy.Keyed(element, body(element)));
      }
    } finally {
      values.remove(variable);
    }
    boolean distinct = type instanceof SetType<?, ?> || type instanceof OrderedSetType<?, ?>;
    return LoopNodes.SortedBy.sorted(keyed, distinct);
  }

  private Object select(Collection<?> elements, CollectionKind kind, boolean wanted) {
    Collection<Object> result = CollectionOperations.create(kind);
    values.add(variable, null);
    try {
      for (Object element : elements) {
        Object value = body(element);
        if (value == null || value == invalid) {
          return invalid;
        }
        if ((Boolean) value == wanted) {
          result.add(element);
        }
      }
    } finally {
      values.remove(variable);
    }
    return result;
  }

  private Object collect(Collection<?> elements, CollectionKind kind, boolean flatten) {
    Collection<Object> result = CollectionOperations.create(kind);
    values.add(variable, null);
    try {
      for (Object element : elements) {
        Object value = body(element);
        if (value == invalid) {
          return value;
        }
        if (flatten && value instanceof Collection<?> several) {
          result.addAll(CollectionOperations.flatten(several));
          Limits.requireElements(result.size());
        } else {
          result.add(value);
        }
      }
    } finally {
      values.remove(variable);
    }
    return result;
  }

  private Object closure(Collection<?> sources) {
    values.add(variable, null);
    try {
      boolean ordered = loop.getType() instanceof OrderedSetType<?, ?>;
      Collection<Object> result = closure(sources, ordered, this::body);
      return result == null ? invalid : result;
    } finally {
      values.remove(variable);
    }
  }

  /**
   * What can be reached. Depth first, like Eclipse OCL, but with a stack of its own, so that a long
   * chain of elements does not need a deep Java stack. As there, the sources themselves are left
   * out unless they are reached again.
   *
   * @param step leads from an element to some others, to one, or to null
   * @return null if a step is invalid
   */
  static Collection<Object> closure(
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

  private Object body(Object element) {
    values.replace(variable, element);
    return evaluator.safeVisitExpression(loop.getBody());
  }
}
