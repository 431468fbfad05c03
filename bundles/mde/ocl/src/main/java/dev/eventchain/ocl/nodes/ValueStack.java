package dev.eventchain.ocl.nodes;

import java.util.Arrays;

/** Names and their values; the latest value of a name hides the earlier ones. */
public final class ValueStack {

  private String[] names = new String[16];
  private Object[] values = new Object[16];
  private int size;

  public int size() {
    return size;
  }

  void push(String name, Object value) {
    if (size == names.length) {
      names = Arrays.copyOf(names, size * 2);
      values = Arrays.copyOf(values, size * 2);
    }
    names[size] = name;
    values[size++] = value;
  }

  /** Returns the latest value of a name; {@code null} if it has none. */
  Object get(String name) {
    int index = find(name);
    return index < 0 ? null : values[index];
  }

  /** Replaces the value that was pushed at a height. */
  void set(int height, Object value) {
    values[height] = value;
  }

  /** Removes the latest value of a name and returns it. */
  Object remove(String name) {
    int index = find(name);
    if (index < 0) {
      return null;
    }
    Object removed = values[index];
    size--;
    if (index < size) {
      System.arraycopy(names, index + 1, names, index, size - index);
      System.arraycopy(values, index + 1, values, index, size - index);
    }
    names[size] = null;
    values[size] = null;
    return removed;
  }

  /** Removes everything above a height from {@link #size()}. */
  public void truncate(int height) {
    while (size > height) {
      size--;
      names[size] = null;
      values[size] = null;
    }
  }

  private int find(String name) {
    int hash = name.hashCode();
    for (int i = size - 1; i >= 0; i--) {
      // Strings cache their hash codes, which usually differ for different names.
      if (names[i].hashCode() == hash && names[i].equals(name)) {
        return i;
      }
    }
    return -1;
  }
}
