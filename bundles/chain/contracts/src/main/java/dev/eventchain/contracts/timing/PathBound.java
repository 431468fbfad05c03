package dev.eventchain.contracts.timing;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** A bound on the latency along a path whose periods and response times are known. */
interface PathBound {

  /** Returns the bound; empty if the path does not meet its assumptions. */
  Optional<Bound> of(LatencyType type, List<Segment> path);

  /**
   * Returns a bound of its parts.
   *
   * @param waiting by segment
   * @param counted the part of each segment's response time that counts
   */
  static Bound sum(Method method, List<Segment> path, List<Long> waiting, List<Long> counted) {
    List<Bound.Share> shares = new ArrayList<>();
    long time = 0;
    for (int i = 0; i < path.size(); i++) {
      shares.addAll(path.get(i).shares(waiting.get(i), counted.get(i)));
      time = Math.addExact(time, Math.addExact(waiting.get(i), counted.get(i)));
    }
    return new Bound(method, time, shares);
  }
}
