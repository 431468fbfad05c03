package dev.eventchain.ocl.nodes;

import dev.eventchain.ocl.values.KeyIndex;
import java.util.Collection;

/**
 * The source of a loop to which only those elements matter whose key is equal to some value, such
 * as {@code x.name = self.name}. Gives these only, so that looking for each element of a model
 * among all of them takes no longer for each when the model is larger.
 */
public final class KeyedElements extends Node {

  /** To go through fewer elements is as fast as to look them up. */
  private static final int WORTHWHILE = 16;

  private final Node source;
  private final int slot;
  private final Node key;
  private final Node wanted;

  /**
   * Makes a source.
   *
   * @param slot the variable of the loop
   * @param key depends on this variable and on the model only
   * @param wanted does not depend on this variable
   */
  public KeyedElements(Node source, int slot, Node key, Node wanted) {
    this.source = source;
    this.slot = slot;
    this.key = key;
    this.wanted = wanted;
  }

  /**
   * The elements that matter, in their order, or all of them; invalid if it is not a collection.
   */
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
