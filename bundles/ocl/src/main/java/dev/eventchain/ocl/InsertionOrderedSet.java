package dev.eventchain.ocl;

import java.util.AbstractSet;
import java.util.Collection;
import java.util.Iterator;
import java.util.LinkedHashSet;
import java.util.Set;

/**
 * An OCL Set that is walked in the order in which its elements came. It is no {@link
 * LinkedHashSet}, because Eclipse OCL takes that for an OrderedSet, whose equality heeds the order.
 */
final class InsertionOrderedSet<E> extends AbstractSet<E> {

  private final Set<E> elements;

  InsertionOrderedSet() {
    elements = new LinkedHashSet<>();
  }

  InsertionOrderedSet(Collection<? extends E> source) {
    elements = new LinkedHashSet<>(source);
  }

  @Override
  public boolean add(E element) {
    return elements.add(element);
  }

  @Override
  public boolean contains(Object element) {
    return elements.contains(element);
  }

  @Override
  public boolean remove(Object element) {
    return elements.remove(element);
  }

  @Override
  public Iterator<E> iterator() {
    return elements.iterator();
  }

  @Override
  public int size() {
    return elements.size();
  }

  @Override
  public void clear() {
    elements.clear();
  }
}
