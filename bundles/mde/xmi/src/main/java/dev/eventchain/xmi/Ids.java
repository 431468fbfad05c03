package dev.eventchain.xmi;

import org.eclipse.emf.ecore.EObject;

/**
 * The ids of one file and their elements, with one instance of each text. A hash table of two
 * arrays, since a large model has an id for each element and more than one reference to it.
 */
final class Ids {

  private static final int FIRST_SIZE = 64;
  private static final int GOLDEN_RATIO = 0x9E3779B9;

  private String[] ids = new String[FIRST_SIZE];
  private EObject[] elements = new EObject[FIRST_SIZE];
  private int count;

  /** Returns the element with an id; null if there is none so far. */
  EObject get(String id) {
    return elements[slotOf(id)];
  }

  /** Gives an element an id, unless another one has it; returns that one, else null. */
  EObject putIfAbsent(String id, EObject element) {
    int slot = place(id);
    EObject first = elements[slot];
    if (first == null) {
      elements[slot] = element;
    }
    return first;
  }

  /** Returns the instance to keep of an id, which may be that of a later element. */
  String shared(String id) {
    int slot = place(id); // first, as it may replace the array
    return ids[slot];
  }

  /** Returns the slot of an id, which has one from now on. */
  private int place(String id) {
    if (count * 3 >= ids.length * 2) {
      grow();
    }
    int slot = slotOf(id);
    if (ids[slot] == null) {
      ids[slot] = id;
      count++;
    }
    return slot;
  }

  /** Returns the slot of an id, or the free one for it. */
  private int slotOf(String id) {
    int mask = ids.length - 1;
    int hash = id.hashCode();
    // Spread by the upper bits: tools count ids up, whose hashes then follow each other.
    int slot = (hash * GOLDEN_RATIO) >>> Integer.numberOfLeadingZeros(mask);
    while (ids[slot] != null && !(ids[slot].hashCode() == hash && ids[slot].equals(id))) {
      slot = (slot + 1) & mask;
    }
    return slot;
  }

  private void grow() {
    String[] known = ids;
    EObject[] owners = elements;
    ids = new String[known.length * 2];
    elements = new EObject[known.length * 2];
    for (int i = 0; i < known.length; i++) {
      if (known[i] != null) {
        int slot = slotOf(known[i]);
        ids[slot] = known[i];
        elements[slot] = owners[i];
      }
    }
  }
}
