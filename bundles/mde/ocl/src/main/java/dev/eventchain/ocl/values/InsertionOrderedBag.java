package dev.eventchain.ocl.values;

import java.util.AbstractCollection;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import org.eclipse.ocl.util.Bag;

/** An OCL Bag with iteration in insertion order. */
final class InsertionOrderedBag<E> extends AbstractCollection<E> implements Bag<E> {

  private final List<E> elements;

  /** The count of each element; computed on first use, dropped by every change. */
  private volatile Map<Object, Integer> counts;

  InsertionOrderedBag() {
    elements = new ArrayList<>();
  }

  InsertionOrderedBag(Collection<? extends E> source) {
    elements = new ArrayList<>(source);
  }

  @Override
  public boolean add(E element) {
    counts = null;
    return elements.add(element);
  }

  @Override
  public int count(Object element) {
    return counts().getOrDefault(Values.key(element), 0);
  }

  @Override
  public boolean contains(Object element) {
    return counts().containsKey(Values.key(element));
  }

  /** Removes every occurrence, as OCL's {@code excluding} expects of a bag. */
  @Override
  public boolean remove(Object element) {
    counts = null;
    return elements.removeIf(each -> Values.equal(each, element));
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
    counts = null;
    elements.clear();
  }

  /** Returns whether another bag has the same elements, each as often, in any order. */
  @Override
  public boolean equals(Object other) {
    return other instanceof InsertionOrderedBag<?> bag && counts().equals(bag.counts());
  }

  @Override
  public int hashCode() {
    return counts().hashCode();
  }

  private Map<Object, Integer> counts() {
    Map<Object, Integer> known = counts;
    if (known == null) {
      known = new HashMap<>();
      for (E element : elements) {
        known.merge(Values.key(element), 1, Integer::sum);
      }
      counts = known;
    }
    return known;
  }
}
