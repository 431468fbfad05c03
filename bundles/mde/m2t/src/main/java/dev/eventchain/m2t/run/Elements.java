package dev.eventchain.m2t.run;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;

/** What a loop goes through: a collection's elements, a single value, or nothing for null. */
public final class Elements {

  private Elements() {}

  /** The elements of a value, which may change meanwhile. */
  public static Collection<?> of(Object value) {
    if (value instanceof Collection<?> collection) {
      return new ArrayList<>(collection);
    }
    return value == null ? List.of() : List.of(value);
  }

  /** The same without a copy, for a walk through them at once. */
  public static Collection<?> read(Object value) {
    return value instanceof Collection<?> collection ? collection : of(value);
  }
}
