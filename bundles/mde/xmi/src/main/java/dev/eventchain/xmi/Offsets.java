package dev.eventchain.xmi;

import dev.eventchain.diagnostics.SourceText;
import java.util.Arrays;
import org.eclipse.emf.ecore.EObject;

/**
 * The offsets in a text where elements start. A hash table of two arrays, since a large model has
 * millions of elements and few lookups.
 */
final class Offsets {

  private static final int FIRST_SIZE = 64;
  private static final int GOLDEN_RATIO = 0x9E3779B9;

  private final SourceText text;
  private EObject[] elements = new EObject[FIRST_SIZE];
  private int[] offsets = new int[FIRST_SIZE];
  private int count;

  Offsets(SourceText text) {
    this.text = text;
  }

  SourceText text() {
    return text;
  }

  /** Sets the offset of an element, replacing an earlier one. */
  void put(EObject element, int offset) {
    if (count * 3 >= elements.length * 2) {
      grow();
    }
    int slot = slotOf(element);
    if (elements[slot] == null) {
      elements[slot] = element;
      count++;
    }
    offsets[slot] = offset;
  }

  /** Returns the offset of an element; negative if unknown. */
  int get(EObject element) {
    int slot = slotOf(element);
    return elements[slot] == null ? -1 : offsets[slot];
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
    elements = new EObject[known.length * 2];
    offsets = Arrays.copyOf(starts, elements.length);
    for (int i = 0; i < known.length; i++) {
      if (known[i] != null) {
        int slot = slotOf(known[i]);
        elements[slot] = known[i];
        offsets[slot] = starts[i];
      }
    }
  }
}
