package dev.eventchain.contracts.timing;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Bounds for any phases, which sum up the hops: Davare's, and Dürr's where priorities help. */
final class SummedBound implements PathBound {

  private final Method method;

  private SummedBound(Method method) {
    this.method = method;
  }

  /** Returns the bound that takes the response times of all tasks. */
  static SummedBound davare() {
    return new SummedBound(Method.DAVARE);
  }

  /**
   * Returns the bound in which a task does not wait for another one of higher priority on the same
   * processor: that has ended before it starts.
   */
  static SummedBound duerr() {
    return new SummedBound(Method.DUERR);
  }

  @Override
  public Optional<Bound> of(LatencyType type, List<Segment> path) {
    List<Long> waiting = new ArrayList<>();
    List<Long> counted = new ArrayList<>();
    waiting.add(type == LatencyType.REACTION ? path.get(0).firstWaiting() : 0);
    for (int i = 0; i < path.size() - 1; i++) {
      Segment writer = path.get(i);
      long hop = hop(type, writer, path.get(i + 1));
      long response = Math.min(writer.response(), hop);
      counted.add(response);
      waiting.add(hop - response);
    }
    counted.add(path.get(path.size() - 1).response());
    return Optional.of(PathBound.sum(method, path, waiting, counted));
  }

  /** Returns the longest time between the releases of a writer and of the reader of its output. */
  private long hop(LatencyType type, Segment writer, Segment reader) {
    long delay = method == Method.DUERR ? writer.delayBefore(reader) : writer.response();
    return type == LatencyType.REACTION
        ? Math.max(writer.response(), Math.addExact(reader.period(), delay))
        : Math.addExact(writer.period(), delay);
  }
}
