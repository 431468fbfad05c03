package dev.eventchain.ocl.values;

import java.util.AbstractSet;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Iterator;
import java.util.List;
import java.util.Objects;
import java.util.Set;

/**
 * An OCL Set with iteration in insertion order. It is no {@code LinkedHashSet}, which Eclipse OCL
 * takes for an OrderedSet, whose equality depends on the order.
 */
public final class InsertionOrderedSet<E> extends AbstractSet<E> {

  /** The number of elements up to which comparing is faster than hashing. */
  private static final int FEW = 8;

  /** The elements while they are few, or as given; otherwise null. */
  private List<E> listed;

  /** True if the list was given, so that it must not be changed. */
  private boolean given;

  /** The elements if they are many; created on first use if they were given as a list. */
  private volatile Set<E> hashed;

  public InsertionOrderedSet() {
    this(new ArrayList<>(), false);
  }

  public InsertionOrderedSet(Collection<? extends E> source) {
    if (source.size() > FEW) {
      hashed = new ValueSet<>(source);
    } else {
      listed = new ArrayList<>(source.size());
      addAll(source);
    }
  }

  private InsertionOrderedSet(List<E> listed, boolean given) {
    this.listed = listed;
    this.given = given;
  }

  /** Returns a set backed by a list, which has no duplicates and must not change any more. */
  public static <E> InsertionOrderedSet<E> ofDistinct(List<E> elements) {
    return new InsertionOrderedSet<>(elements, true);
  }

  private Set<E> hashed() {
    Set<E> known = hashed;
    if (known == null) {
      // A race between threads is harmless: the results are equal.
      known = new ValueSet<>(listed);
      hashed = known;
    }
    return known;
  }

  /** Returns the elements in a modifiable collection that suits a size. */
  private Collection<E> changed(int size) {
    if (listed == null || size > FEW) {
      Set<E> result = hashed();
      listed = null;
      return result;
    } else if (given) {
      listed = new ArrayList<>(listed);
      given = false;
    }
    return listed;
  }

  private boolean areFew() {
    return listed != null && listed.size() <= FEW;
  }

  /** Returns the index of an element among a few; -1 if it is not. */
  private int indexOf(Object element) {
    Object key = Values.key(element);
    for (int i = 0; i < listed.size(); i++) {
      E each = listed.get(i);
      if (each == element || Objects.equals(key, Values.key(each))) {
        return i;
      }
    }
    return -1;
  }

  @Override
  public boolean add(E element) {
    return (!areFew() || indexOf(element) < 0) && changed(size() + 1).add(element);
  }

  @Override
  public boolean contains(Object element) {
    return areFew() ? indexOf(element) >= 0 : hashed().contains(element);
  }

  @Override
  public boolean remove(Object element) {
    if (!areFew()) {
      return changed(size()).remove(element);
    }
    int index = indexOf(element);
    if (index >= 0) {
      E found = listed.get(index);
      changed(size()).remove(found);
    }
    return index >= 0;
  }

  @Override
  public Iterator<E> iterator() {
    return listed == null ? hashed.iterator() : listed.iterator();
  }

  @Override
  public int size() {
    return listed == null ? hashed.size() : listed.size();
  }

  @Override
  public void clear() {
    listed = new ArrayList<>();
    given = false;
    hashed = null;
  }

  @Override
  public boolean equals(Object other) {
    return super.equals(other);
  }

  @Override
  public int hashCode() {
    int sum = 0;
    for (E element : this) {
      sum += Objects.hashCode(Values.key(element));
    }
    return sum;
  }
}
