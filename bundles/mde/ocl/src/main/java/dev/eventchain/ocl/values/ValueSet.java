package dev.eventchain.ocl.values;

import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.Map;

/**
 * An OCL OrderedSet, which contains no two values that are equal in OCL, though Java may
 * distinguish them, such as 1 and 1.0.
 */
public final class ValueSet<E> extends LinkedHashSet<E> {

  private static final long serialVersionUID = 1L;

  /** The elements that differ from their keys, by key; null if there are none. */
  private transient Map<Object, E> others;

  public ValueSet() {}

  public ValueSet(Collection<? extends E> elements) {
    super(Math.max(2 * elements.size(), 11));
    elements.forEach(this::add);
  }

  @Override
  public boolean add(E element) {
    Object key = Values.key(element);
    if (others != null && others.containsKey(key)) {
      return false;
    } else if (key == element) {
      return super.add(element);
    } else if (super.contains(key)) {
      return false;
    }
    if (others == null) {
      others = new HashMap<>();
    }
    others.put(key, element);
    return super.add(element);
  }

  @Override
  public boolean contains(Object element) {
    Object key = Values.key(element);
    return super.contains(key) || (others != null && others.containsKey(key));
  }

  @Override
  public boolean remove(Object element) {
    Object key = Values.key(element);
    if (others != null && others.containsKey(key)) {
      return super.remove(others.remove(key));
    }
    return super.remove(key);
  }

  @Override
  public void clear() {
    others = null;
    super.clear();
  }

  @Override
  public boolean equals(Object other) {
    return super.equals(other);
  }

  @Override
  public int hashCode() {
    int sum = 0;
    for (E element : this) {
      Object key = Values.key(element);
      sum += key == null ? 0 : key.hashCode();
    }
    return sum;
  }
}
