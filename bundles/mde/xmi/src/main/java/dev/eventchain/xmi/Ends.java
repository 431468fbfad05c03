package dev.eventchain.xmi;

import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EReference;

/**
 * The ends of references with an opposite, as files name them, by numbers in the order of the
 * files. Arrays instead of objects, since a large model has millions of ends.
 */
final class Ends {

  private static final int FIRST_SIZE = 16;
  private static final int GOLDEN_RATIO = 0x9E3779B9;

  private EObject[] elements = new EObject[FIRST_SIZE];
  private EReference[] features = new EReference[FIRST_SIZE];
  private Object[] targets = new Object[FIRST_SIZE];
  private int[] tags = new int[FIRST_SIZE];
  private int size;

  /** The first end of each link, by its number and one; null before {@link #firstOf}. */
  private int[] links;

  /** Returns the ends of several files, one file after the other. */
  static Ends of(List<Ends> files) {
    if (files.size() == 1) {
      return files.get(0);
    }
    Ends all = new Ends();
    for (Ends file : files) {
      for (int end = 0; end < file.size; end++) {
        all.add(file.elements[end], file.features[end], file.targets[end], file.tags[end]);
      }
    }
    return all;
  }

  /**
   * Adds an end.
   *
   * @param target the element, or its id in the file
   * @param tag the offset of the start tag of the element that has the reference
   */
  void add(EObject element, EReference feature, Object target, int tag) {
    if (size == elements.length) {
      int larger = size * 2;
      elements = Arrays.copyOf(elements, larger);
      features = Arrays.copyOf(features, larger);
      targets = Arrays.copyOf(targets, larger);
      tags = Arrays.copyOf(tags, larger);
    }
    elements[size] = element;
    features[size] = feature;
    targets[size] = target;
    tags[size++] = tag;
  }

  int size() {
    return size;
  }

  EObject element(int end) {
    return elements[end];
  }

  EReference feature(int end) {
    return features[end];
  }

  /** Returns the target, as given to {@link #add}, or the element that it was resolved to. */
  Object target(int end) {
    return targets[end];
  }

  int tag(int end) {
    return tags[end];
  }

  /** Replaces the targets by their elements, or by null where there is none. */
  void resolve(Function<Object, EObject> elementOf) {
    links = null;
    for (int end = 0; end < size; end++) {
      targets[end] = targets[end] == null ? null : elementOf.apply(targets[end]);
    }
  }

  /** Returns the number of the first end that says the same; its own if there is no earlier one. */
  int firstOf(int end) {
    return find(elements[end], features[end], targets[end]);
  }

  /** Returns whether the element at the other end of a reference names it back. */
  boolean isNamedBack(int end) {
    return find((EObject) targets[end], features[end].getEOpposite(), elements[end]) >= 0;
  }

  /** Frees the memory of what {@link #firstOf} and {@link #isNamedBack} find, until asked again. */
  void forgetLinks() {
    links = null;
  }

  /** Returns the number of the first end of a link between elements; negative for none. */
  private int find(EObject element, EReference feature, Object target) {
    if (links == null) {
      link();
    }
    return links[slotOf(element, feature, target)] - 1;
  }

  private void link() {
    links = new int[Integer.highestOneBit(Math.max(1, size)) * 4];
    for (int end = 0; end < size; end++) {
      int slot = slotOf(elements[end], features[end], targets[end]);
      if (links[slot] == 0) {
        links[slot] = end + 1;
      }
    }
  }

  /** Returns the slot of a link, or the free one for it. */
  private int slotOf(EObject element, EReference feature, Object target) {
    int mask = links.length - 1;
    int hash = System.identityHashCode(element) * 31 + System.identityHashCode(target);
    int slot = (((hash * 31 + System.identityHashCode(feature)) * GOLDEN_RATIO) >>> 7) & mask;
    while (links[slot] != 0 && !isLink(links[slot] - 1, element, feature, target)) {
      slot = (slot + 1) & mask;
    }
    return slot;
  }

  private boolean isLink(int end, EObject element, EReference feature, Object target) {
    return elements[end] == element && targets[end] == target && features[end] == feature;
  }
}
