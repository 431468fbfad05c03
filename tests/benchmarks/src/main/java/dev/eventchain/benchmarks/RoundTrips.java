package dev.eventchain.benchmarks;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Round-trip times of messages, in ns. */
final class RoundTrips {

  private final List<Long> times = new ArrayList<>();
  private long processorTime;

  void add(long time) {
    times.add(time);
  }

  void clear() {
    times.clear();
    processorTime = 0;
  }

  /** Sends a message a number of times in sequence. */
  void measure(WirePeer peer, byte[] bytes, int count) throws IOException {
    long before = peer.processorTime();
    for (int i = 0; i < count; i++) {
      times.add(peer.roundTrip(bytes));
    }
    processorTime += peer.processorTime() - before;
  }

  void print(String what) {
    System.out.printf(
        Locale.ROOT,
        "%-54s p50 %8.1f   p99 %8.1f us of %d",
        what,
        percentile(50) / 1e3,
        percentile(99) / 1e3,
        times.size());
    if (processorTime > 0) {
      System.out.printf(
          Locale.ROOT, ", %.1f us on its processor", processorTime / 1e3 / times.size());
    }
    System.out.println();
  }

  void printRatio(RoundTrips other) {
    System.out.printf(
        Locale.ROOT,
        "%-54s p50 %8.2f   p99 %8.2f times%n",
        "  ratio",
        percentile(50) / other.percentile(50),
        percentile(99) / other.percentile(99));
  }

  private double percentile(int percent) {
    List<Long> sorted = times.stream().sorted().toList();
    return sorted.get(Math.min(sorted.size() - 1, sorted.size() * percent / 100));
  }
}
