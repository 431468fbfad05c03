package dev.eventchain.ocl.values;

import java.util.AbstractCollection;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.Iterator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import org.eclipse.emf.ecore.EEnumLiteral;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EStructuralFeature;
import org.eclipse.emf.ecore.impl.BasicEObjectImpl;
import org.eclipse.emf.ecore.impl.EEnumLiteralImpl;
import org.eclipse.ocl.ecore.EcoreEnvironmentFactory;
import org.eclipse.ocl.util.CollectionUtil;
import org.eclipse.ocl.util.ObjectUtil;
import org.eclipse.ocl.util.Tuple;

/** Equality of values in OCL: numbers by value, not by Java type. */
public final class Values {

  /** The equality key of a tuple. */
  private record Parts(Map<String, Object> keys) {}

  /** The value that stands for OCL's invalid, also inside Eclipse OCL. */
  public static final Object INVALID =
      EcoreEnvironmentFactory.INSTANCE.createEnvironment().getOCLStandardLibrary().getInvalid();

  private Values() {}

  /**
   * Returns whether a value is a collection. Tests common classes first: Java tests classes fast,
   * but searches all interfaces of a class for a missing one.
   */
  public static boolean isCollection(Object value) {
    return !(value instanceof String)
        && !(value instanceof BasicEObjectImpl)
        && (value instanceof AbstractCollection<?> || value instanceof Collection<?>);
  }

  /** Returns whether values are equal, none of which is invalid. */
  public static boolean equal(Object first, Object second) {
    if (first == second) {
      return true;
    } else if (first instanceof Integer one && second instanceof Integer other) {
      return one.intValue() == other.intValue();
    } else if (first == null || second == null) {
      return false;
    } else if (first instanceof String || isPlainObject(first)) {
      return first.equals(second);
    } else if (Numbers.isNumber(first) && Numbers.isNumber(second)) {
      return Numbers.compare(first, second) == 0;
    } else if (first instanceof Collection<?> one && second instanceof Collection<?> other) {
      return equal(one, other);
    } else if (first instanceof Tuple<?, ?> && second instanceof Tuple<?, ?>) {
      return key(first).equals(key(second));
    }
    return ObjectUtil.equal(first, second);
  }

  private static boolean equal(Collection<?> first, Collection<?> second) {
    boolean lists = first instanceof List<?> && second instanceof List<?>;
    boolean orderedSets = first instanceof LinkedHashSet<?> && second instanceof LinkedHashSet<?>;
    if (!lists && !orderedSets) {
      return CollectionUtil.equals(first, second);
    } else if (first.size() != second.size()) {
      return false;
    }
    Iterator<?> others = second.iterator();
    for (Object each : first) {
      if (!equal(each, others.next())) {
        return false;
      }
    }
    return true;
  }

  /** Returns whether an object is equal to itself only, unlike enumeration literals. */
  static boolean isPlainObject(Object value) {
    return value instanceof BasicEObjectImpl
        ? !(value instanceof EEnumLiteralImpl)
        : value instanceof EObject && !(value instanceof EEnumLiteral);
  }

  /** Returns a key that is equal in Java for values that are equal in OCL. */
  public static Object key(Object value) {
    if (value instanceof Integer || value instanceof String || value instanceof BasicEObjectImpl) {
      return value;
    } else if (value instanceof Number) {
      return Numbers.key(value);
    } else if (value instanceof List<?> elements) {
      return keys(elements);
    }
    return value instanceof Tuple<?, ?> tuple ? parts(tuple) : value;
  }

  private static List<?> keys(List<?> elements) {
    List<Object> keys = new ArrayList<>(elements.size());
    boolean changed = false;
    for (Object element : elements) {
      Object key = key(element);
      changed |= key != element;
      keys.add(key);
    }
    return changed ? keys : elements;
  }

  private static Parts parts(Tuple<?, ?> tuple) {
    Map<String, Object> keys = byName(tuple);
    keys.replaceAll((name, value) -> key(value));
    return new Parts(keys);
  }

  /** Returns the values of a tuple by the names of its parts. */
  @SuppressWarnings("unchecked")
  public // the tuples of Ecore's OCL have properties of Ecore
  static Map<String, Object> byName(Tuple<?, ?> tuple) {
    Map<String, Object> values = new HashMap<>();
    for (Object property : tuple.getTupleType().oclProperties()) {
      Object value = ((Tuple<?, EStructuralFeature>) tuple).getValue((EStructuralFeature) property);
      values.put(((EStructuralFeature) property).getName(), value);
    }
    return values;
  }

  public static boolean contains(Collection<?> elements, Object value) {
    if (elements instanceof IntegerRange range) {
      return range.contains(key(value));
    }
    boolean plain = value == null || value instanceof String || value instanceof BasicEObjectImpl;
    return (plain || !(elements instanceof List<?>))
        ? elements.contains(value)
        : indexOf(elements, value) > 0;
  }

  public static boolean containsAll(Collection<?> elements, Collection<?> others) {
    for (Object each : others) {
      if (!contains(elements, each)) {
        return false;
      }
    }
    return true;
  }

  public static boolean containsNone(Collection<?> elements, Collection<?> others) {
    for (Object each : others) {
      if (contains(elements, each)) {
        return false;
      }
    }
    return true;
  }

  /** Returns the index of a value from 1; 0 if it is not an element. */
  public static int indexOf(Collection<?> elements, Object value) {
    boolean object = isPlainObject(value);
    int index = 1;
    for (Object each : elements) {
      if (object ? each == value : equal(each, value)) {
        return index;
      }
      index++;
    }
    return 0;
  }

  public static int count(Collection<?> elements, Object value) {
    if (elements instanceof InsertionOrderedBag<?> bag) {
      return bag.count(value);
    }
    int count = 0;
    for (Object each : elements) {
      count += equal(each, value) ? 1 : 0;
    }
    return count;
  }

  /** Returns the value in OCL's representation; see {@link Numbers#normal}. */
  public static Object normal(Object value) {
    return value instanceof Collection<?> elements && !(value instanceof Iterator<?>)
        ? normal(elements)
        : Numbers.normal(value);
  }

  /** Returns the elements in OCL's representation; the same collection if nothing changes. */
  static Collection<?> normal(Collection<?> elements) {
    boolean changed = false;
    for (Object each : elements) {
      changed |= Numbers.normal(each) != each;
    }
    if (!changed) {
      return elements;
    }
    List<Object> normal = new ArrayList<>(elements.size());
    elements.forEach(each -> normal.add(Numbers.normal(each)));
    return CollectionOperations.create(CollectionOperations.kindOf(elements), normal);
  }
}
