package dev.eventchain.xmi;

import dev.eventchain.diagnostics.SourceText;
import org.eclipse.emf.ecore.EObject;

/**
 * The offsets in a text where elements start, and the ids that the text gives them. A hash table of
 * arrays, since a large model has millions of elements and few lookups.
 */
final class Offsets {

  private static final int FIRST_SIZE = 64;
  private static final int GOLDEN_RATIO = 0x9E3779B9;

  private final SourceText text;
  private EObject[] elements = new EObject[FIRST_SIZE];

  /** The offset of each element, and one; 0 if it is unknown. */
  private int[] offsets = new int[FIRST_SIZE];

  /** The id of each element; null if none has one. */
  private String[] ids;

  private int count;

  Offsets(SourceText text) {
    this.text = text;
  }

  SourceText text() {
    return text;
  }

  /** Sets the offset of an element, replacing an earlier one. */
  void put(EObject element, int offset) {
    int slot = place(element);
    offsets[slot] = offset + 1;
  }

  /** Sets the id of an element, replacing an earlier one; null for none. */
  void identify(EObject element, String id) {
    int slot = place(element);
    if (ids == null) {
      ids = new String[elements.length];
    }
    ids[slot] = id;
  }

  /** Returns the id of an element; null if it has none. */
  String idOf(EObject element) {
    return ids == null ? null : ids[slotOf(element)];
  }

  /** Returns the slot of an element, which has one from now on. */
  private int place(EObject element) {
    if (count * 3 >= elements.length * 2) {
      grow();
    }
    int slot = slotOf(element);
    if (elements[slot] == null) {
      elements[slot] = element;
      count++;
    }
    return slot;
  }

  /** Returns the offset of an element; negative if unknown. */
  int get(EObject element) {
    return offsets[slotOf(element)] - 1;
  }

  /** Returns the slot of an element, or the free one for it. */
  private int slotOf(EObject element) {
    int mask = elements.length - 1;
    int slot = ((System.identityHashCode(element) * GOLDEN_RATIO) >>> 8) & mask;
    while (elements[slot] != null && elements[slot] != element) {
      slot = (slot + 1) & mask;
    }
    return slot;
  }

  private void grow() {
    EObject[] known = elements;
    int[] starts = offsets;
    String[] names = ids;
    elements = new EObject[known.length * 2];
    offsets = new int[elements.length];
    ids = names == null ? null : new String[elements.length];
    for (int i = 0; i < known.length; i++) {
      if (known[i] != null) {
        int slot = slotOf(known[i]);
        elements[slot] = known[i];
        offsets[slot] = starts[i];
        if (names != null) {
          ids[slot] = names[i];
        }
      }
    }
  }
}
