package dev.eventchain.ocl.nodes;

import dev.eventchain.ocl.values.KeyIndex;
import java.util.Collection;

/**
 * The source of a loop that depends only on elements with a certain key, such as {@code x.name =
 * self.name}. Returns only these, so that the time of a lookup does not grow with the model.
 */
public final class KeyedElements extends Node {

  /** The number of elements below which iteration is as fast as an index. */
  private static final int WORTHWHILE = 16;

  private final Node source;
  private final int slot;
  private final Node key;
  private final Node wanted;

  /**
   * Creates a source.
   *
   * @param slot the variable of the loop
   * @param key the key, which depends on this variable and on the model only
   * @param wanted the value to look up, which does not depend on this variable
   */
  public KeyedElements(Node source, int slot, Node key, Node wanted) {
    this.source = source;
    this.slot = slot;
    this.key = key;
    this.wanted = wanted;
  }

  /** Returns the relevant elements in order, or all; invalid if the source is no collection. */
  @Override
  Object evaluate(Frame frame) {
    Collection<?> elements = source.elements(frame);
    if (elements == null) {
      return INVALID;
    }
    if (elements.size() < WORTHWHILE) {
      return elements;
    }
    KeyIndex index = frame.run.index(this, elements);
    if (index == null || !index.isReady(element -> keyOf(element, frame))) {
      return elements;
    }
    Object value = wanted.evaluate(frame);
    return KeyIndex.isKey(value) ? index.of(value) : elements;
  }

  private Object keyOf(Object element, Frame frame) {
    frame.run.step();
    frame.slots[slot] = element;
    return key.evaluate(frame);
  }
}
