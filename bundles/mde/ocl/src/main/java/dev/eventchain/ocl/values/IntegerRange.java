package dev.eventchain.ocl.values;

import java.util.AbstractList;
import java.util.Objects;
import java.util.RandomAccess;

/** A range of integers, which takes constant memory. */
public final class IntegerRange extends AbstractList<Object> implements RandomAccess {
  private final long first;
  private final int size;

  private IntegerRange(long first, int size) {
    this.first = first;
    this.size = size;
  }

  public static IntegerRange between(long first, long last) {
    if (last < first) {
      return new IntegerRange(first, 0);
    }
    long more = last - first; // negative if a long cannot hold it
    Limits.requireElements(more < 0 || more == Long.MAX_VALUE ? Long.MAX_VALUE : more + 1);
    return new IntegerRange(first, (int) more + 1);
  }

  @Override
  public Object get(int index) {
    return Numbers.integer(first + Objects.checkIndex(index, size));
  }

  @Override
  public int size() {
    return size;
  }

  /** Tests bounds only, since limits could not stop an iteration. */
  @Override
  public boolean contains(Object value) {
    if (!Numbers.areLong(value, value)) {
      return false;
    }
    long number = ((Number) value).longValue();
    return number >= first && number < first + size;
  }
}
