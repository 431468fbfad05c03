package dev.eventchain.m2t.text;

import java.util.Arrays;

/** Where the parts of a text come from: each mark holds up to the next one. */
public final class OriginMarks {

  /** The origin of what nobody wrote: indentation, and what people put into protected areas. */
  static final int NONE = -1;

  /** The marks of a text that comes from nowhere. */
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

  /** The offset from which a mark holds. */
  int start(int index) {
    return starts[index];
  }

  /** The number of an origin, or {@link #NONE}. */
  int origin(int index) {
    return origins[index];
  }

  /** Says where the text from an offset on comes from; offsets never go down. */
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

  /** Forgets what holds from an offset on. */
  void cut(int offset) {
    while (size > 0 && starts[size - 1] >= offset) {
      size--;
    }
  }

  /** The marks of the text from an offset on, as its own text. */
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

  /** The marks of a part of the text, as its own text. */
  public OriginMarks between(int from, int to) {
    OriginMarks part = new OriginMarks();
    for (int i = 0; i < size && starts[i] < to; i++) {
      part.add(Math.max(0, starts[i] - from), origins[i]);
    }
    return part;
  }
}
