package dev.eventchain.m2t.text;

import java.util.Arrays;

/** Origins of the parts of a text: each mark holds up to the next one. */
public final class OriginMarks {

  /**
   * Origin of text that is not from a template: indentation, and the content of protected areas.
   */
  static final int NONE = -1;

  /** Marks of a text without origin. */
  public static final OriginMarks NOWHERE = new OriginMarks();

  static {
    NOWHERE.add(0, NONE);
  }

  private int[] starts = new int[64];
  private int[] origins = new int[64];
  private int size;

  int size() {
    return size;
  }

  /** Returns the offset from which a mark holds. */
  int start(int index) {
    return starts[index];
  }

  /** Returns the number of an origin, or {@link #NONE}. */
  int origin(int index) {
    return origins[index];
  }

  /** Adds the origin of the text from an offset on; offsets must not decrease. */
  void add(int start, int origin) {
    if (size > 0 && starts[size - 1] == start) {
      size--;
    }
    if (size > 0 && origins[size - 1] == origin) {
      return;
    }
    if (size == starts.length) {
      starts = Arrays.copyOf(starts, size * 2);
      origins = Arrays.copyOf(origins, size * 2);
    }
    starts[size] = start;
    origins[size++] = origin;
  }

  /** Removes the marks from an offset on. */
  void cut(int offset) {
    while (size > 0 && starts[size - 1] >= offset) {
      size--;
    }
  }

  /** Returns the marks of the text from an offset on, relative to that offset. */
  OriginMarks since(int offset) {
    int first = size;
    while (first > 0 && starts[first - 1] >= offset) {
      first--;
    }
    OriginMarks marks = new OriginMarks();
    if (first > 0) {
      marks.add(0, origins[first - 1]);
    }
    for (int i = first; i < size; i++) {
      marks.add(starts[i] - offset, origins[i]);
    }
    return marks;
  }

  /** Returns the marks of a part of the text, relative to its start. */
  public OriginMarks between(int from, int to) {
    OriginMarks part = new OriginMarks();
    for (int i = 0; i < size && starts[i] < to; i++) {
      part.add(Math.max(0, starts[i] - from), origins[i]);
    }
    return part;
  }
}
