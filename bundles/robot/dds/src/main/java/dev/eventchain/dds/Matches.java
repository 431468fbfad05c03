package dev.eventchain.dds;

import java.time.Duration;
import java.util.function.IntSupplier;

/** Waits for matching endpoints. */
final class Matches {

  private static final long PAUSE_MS = 2;

  private Matches() {}

  static boolean await(IntSupplier matched, int count, Duration timeout) {
    long start = System.nanoTime();
    while (matched.getAsInt() < count) {
      if (System.nanoTime() - start >= timeout.toNanos()) {
        return false;
      }
      try {
        Thread.sleep(PAUSE_MS);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        return matched.getAsInt() >= count;
      }
    }
    return true;
  }
}
