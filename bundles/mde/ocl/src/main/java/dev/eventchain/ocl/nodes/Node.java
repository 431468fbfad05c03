package dev.eventchain.ocl.nodes;

import dev.eventchain.ocl.values.Halted;
import dev.eventchain.ocl.values.Values;
import java.util.Collection;
import org.eclipse.ocl.expressions.CollectionKind;

/**
 * A part of a lowered expression. Immutable and thread-safe.
 *
 * <p>Null stands for OCL's null, {@link #INVALID} for its invalid.
 */
public abstract class Node {

  /** The value that stands for OCL's invalid. */
  static final Object INVALID = Values.INVALID;

  /**
   * Returns the value.
   *
   * @throws Halted if a limit is reached; there are no other exceptions
   */
  abstract Object evaluate(Frame frame);

  /**
   * Returns the value for a caller that only iterates over it and keeps no reference. A collection
   * may be the model's own list, whatever its kind in OCL; only its elements and their order are
   * reliable.
   */
  Object read(Frame frame) {
    return evaluate(frame);
  }

  /** Returns the OCL kind of collections returned by {@link #read}; null if unknown. */
  CollectionKind kindOfElements() {
    return null;
  }

  /** Returns the result of {@link #read} if that is a collection; otherwise null. */
  final Collection<?> elements(Frame frame) {
    Object value = read(frame);
    return Values.isCollection(value) ? (Collection<?>) value : null;
  }

  static boolean isUndefined(Object value) {
    return value == null || value == INVALID;
  }
}
