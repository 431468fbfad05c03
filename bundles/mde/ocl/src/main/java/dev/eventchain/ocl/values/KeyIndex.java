package dev.eventchain.ocl.values;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;

/** An index of the elements of a collection by key. Built at the second use. */
public final class KeyIndex {

  private final Collection<?> elements;
  private Map<Object, List<Object>> byKey;
  private boolean askedBefore;
  private boolean hopeless;

  public KeyIndex(Collection<?> elements) {
    this.elements = elements;
  }

  /** Returns whether this indexes the identical collection; equality may be too costly to test. */
  public boolean isOf(Collection<?> others) {
    return elements == others;
  }

  /**
   * Returns whether the index can be used: not the first time, nor if some elements have values
   * that are {@linkplain #isKey no keys}.
   *
   * @param keyOf returns the key of an element
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

  /** Returns the elements with a key, in their order. */
  public List<Object> of(Object key) {
    return byKey.getOrDefault(key, List.of());
  }

  /** Returns whether equality of a value in OCL is the same as in Java. */
  public static boolean isKey(Object value) {
    boolean simple = value == null || value instanceof String || value instanceof Integer;
    // The marker of invalid is an object, too.
    return simple || (value != Values.INVALID && Values.isPlainObject(value));
  }
}
