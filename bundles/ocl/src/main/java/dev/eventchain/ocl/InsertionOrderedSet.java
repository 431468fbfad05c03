package dev.eventchain.ocl;

import java.util.AbstractSet;
import java.util.Collection;
import java.util.Collections;
import java.util.Iterator;
import java.util.List;
import java.util.Set;

/**
 * An OCL Set that is walked in the order in which its elements came. It is no {@code
 * LinkedHashSet}, because Eclipse OCL takes that for an OrderedSet, whose equality heeds the order.
 */
final class InsertionOrderedSet<E> extends AbstractSet<E> {

  /** The elements as a list, as long as nobody has changed the set; otherwise null. */
  private List<E> distinct;

  /** Made when it is first needed, if the elements came as a list. */
  private volatile Set<E> elements;

  InsertionOrderedSet() {
    this(null, new ValueSet<>());
  }

  InsertionOrderedSet(Collection<? extends E> source) {
    this(null, new ValueSet<>(source));
  }

  private InsertionOrderedSet(List<E> distinct, Set<E> elements) {
    this.distinct = distinct;
    this.elements = elements;
  }

  /** A set of the elements of a list which has none twice and must not change from now on. */
  static <E> InsertionOrderedSet<E> ofDistinct(List<E> elements) {
    return new InsertionOrderedSet<>(Collections.unmodifiableList(elements), null);
  }

  private Set<E> hashed() {
    Set<E> known = elements;
    if (known == null) {
      // Threads may do so at once; they come to the same.
      known = new ValueSet<>(distinct);
      elements = known;
    }
    return known;
  }

  private Set<E> changed() {
    Set<E> result = hashed();
    distinct = null;
    return result;
  }

  @Override
  public boolean add(E element) {
    return changed().add(element);
  }

  @Override
  public boolean contains(Object element) {
    return hashed().contains(element);
  }

  @Override
  public boolean remove(Object element) {
    return changed().remove(element);
  }

  @Override
  public Iterator<E> iterator() {
    return distinct == null ? elements.iterator() : distinct.iterator();
  }

  @Override
  public int size() {
    return distinct == null ? elements.size() : distinct.size();
  }

  @Override
  public void clear() {
    changed().clear();
  }

  @Override
  public boolean equals(Object other) {
    return super.equals(other);
  }

  @Override
  public int hashCode() {
    return hashed().hashCode();
  }
}
