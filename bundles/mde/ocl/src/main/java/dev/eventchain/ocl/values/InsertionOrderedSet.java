package dev.eventchain.ocl.values;

import java.util.AbstractSet;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Iterator;
import java.util.List;
import java.util.Objects;
import java.util.Set;

/**
 * An OCL Set that is walked in the order in which its elements came. It is no {@code
 * LinkedHashSet}, because Eclipse OCL takes that for an OrderedSet, whose equality heeds the order.
 */
public final class InsertionOrderedSet<E> extends AbstractSet<E> {

  /** Comparing so many elements with each other is faster than hashing them. */
  private static final int FEW = 8;

  /** The elements as long as they are few, or as they were given; otherwise null. */
  private List<E> listed;

  /** Whether the list was given, so that it must not be changed. */
  private boolean given;

  /** The elements if they are many; made when it is first needed, if they were given as a list. */
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

  /** A set of the elements of a list which has none twice and must not change from now on. */
  public static <E> InsertionOrderedSet<E> ofDistinct(List<E> elements) {
    return new InsertionOrderedSet<>(elements, true);
  }

  private Set<E> hashed() {
    Set<E> known = hashed;
    if (known == null) {
      // Threads may do so at once; they come to the same.
      known = new ValueSet<>(listed);
      hashed = known;
    }
    return known;
  }

  /** The elements in a form that may be changed, and have so many. */
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

  /** Where an element is among a few; -1 if it does not. */
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
