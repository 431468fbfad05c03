package dev.eventchain.llm.recording;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/** Counts the calls of a run by what they have in common. */
public final class CallCounter {
  private final Map<String, Integer> calls = new ConcurrentHashMap<>();

  /** The number of earlier calls with the same name. */
  public int next(String name) {
    return calls.merge(name, 1, Integer::sum) - 1;
  }
}
