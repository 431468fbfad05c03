package dev.eventchain.llm.recording;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/** Counts the calls of a run by name. */
public final class CallCounter {
  private final Map<String, Integer> calls = new ConcurrentHashMap<>();

  /** Returns the number of earlier calls with the same name. */
  public int next(String name) {
    return calls.merge(name, 1, Integer::sum) - 1;
  }
}
