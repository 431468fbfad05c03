package dev.eventchain.dds;

import java.time.Duration;
import java.util.function.BooleanSupplier;

/** Waits for matching endpoints. */
final class Matches {

  private static final long PAUSE_MS = 2;

  private Matches() {}

  static boolean await(BooleanSupplier matched, Duration timeout) {
    long start = System.nanoTime();
    while (!matched.getAsBoolean()) {
      if (System.nanoTime() - start >= timeout.toNanos()) {
        return false;
      }
      try {
        Thread.sleep(PAUSE_MS);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        return matched.getAsBoolean();
      }
    }
    return true;
  }
}
