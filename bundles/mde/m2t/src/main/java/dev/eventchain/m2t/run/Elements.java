package dev.eventchain.m2t.run;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;

/** Items of a loop: the elements of a collection, a single value, or nothing for null. */
public final class Elements {

  private Elements() {}

  /** Returns the elements of a value, which may change during iteration. */
  public static Collection<?> of(Object value) {
    if (value instanceof Collection<?> collection) {
      return new ArrayList<>(collection);
    }
    return value == null ? List.of() : List.of(value);
  }

  /** Returns the elements without a copy, for immediate iteration. */
  public static Collection<?> read(Object value) {
    return value instanceof Collection<?> collection ? collection : of(value);
  }
}
