package dev.eventchain.ocl.nodes;

import dev.eventchain.ocl.values.Halted;
import dev.eventchain.ocl.values.Values;
import java.util.Collection;
import org.eclipse.ocl.expressions.CollectionKind;

/**
 * A part of a lowered expression. Immutable and thread-safe.
 *
 * <p>Of the values, null is OCL's null, {@link #INVALID} its invalid.
 */
public abstract class Node {

  /** The value that stands for OCL's invalid. */
  static final Object INVALID = Values.INVALID;

  /**
   * The value.
   *
   * @throws Halted if a limit is reached; no other exception gets out
   */
  abstract Object evaluate(Frame frame);

  /**
   * The value for a caller that only walks through it and keeps no reference: a collection may be
   * the model's own list, whatever its kind in OCL. Of the collection, only its elements and their
   * order can be relied on.
   */
  Object read(Frame frame) {
    return evaluate(frame);
  }

  /**
   * The kind in OCL of the collections that {@link #read} gives, if it is known; otherwise null.
   */
  CollectionKind kindOfElements() {
    return null;
  }

  /** What {@link #read} gives, if that is a collection; otherwise null. */
  final Collection<?> elements(Frame frame) {
    Object value = read(frame);
    return Values.isCollection(value) ? (Collection<?>) value : null;
  }

  static boolean isUndefined(Object value) {
    return value == null || value == INVALID;
  }
}
