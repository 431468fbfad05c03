package dev.eventchain.ocl.values;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;

/** The elements of a collection by a key of each. Made when they are asked for a second time. */
public final class KeyIndex {

  private final Collection<?> elements;
  private Map<Object, List<Object>> byKey;
  private boolean askedBefore;
  private boolean hopeless;

  public KeyIndex(Collection<?> elements) {
    this.elements = elements;
  }

  /** Whether it is of this very collection; of one that is equal, it may be too costly to know. */
  public boolean isOf(Collection<?> others) {
    return elements == others;
  }

  /**
   * Whether elements can be asked for, which is not so at the first time, nor if some have keys
   * that are not {@linkplain #isKey such}.
   *
   * @param keyOf gives the key of an element
   */
  public boolean isReady(UnaryOperator<Object> keyOf) {
    if (!askedBefore) {
      askedBefore = true;
      return false;
    }
    if (byKey == null && !hopeless) {
      byKey = indexed(keyOf);
      hopeless = byKey == null;
    }
    return !hopeless;
  }

  private Map<Object, List<Object>> indexed(UnaryOperator<Object> keyOf) {
    Map<Object, List<Object>> found = new HashMap<>();
    for (Object element : elements) {
      Object key = keyOf.apply(element);
      if (!isKey(key)) {
        return null;
      }
      found.computeIfAbsent(key, any -> new ArrayList<>(1)).add(element);
    }
    return found;
  }

  /** The elements that have a key, in their order. */
  public List<Object> of(Object key) {
    return byKey.getOrDefault(key, List.of());
  }

  /** Whether a value is equal in OCL to just those that Java takes for equal to it. */
  public static boolean isKey(Object value) {
    boolean simple = value == null || value instanceof String || value instanceof Integer;
    // What stands for invalid is an object, too.
    return simple || (value != Values.INVALID && Values.isPlainObject(value));
  }
}
