package dev.eventchain.contracts.timing;

import java.util.List;

/**
 * Upper bound on a latency along one path.
 *
 * @param time in ns
 * @param shares the parts of the tasks, in the order of the data; they add up to it
 */
public record Bound(Method method, long time, List<Share> shares) {

  /**
   * Part of a task in a bound, in ns.
   *
   * @param waiting from when its input is there to its release, at most; for the first task of a
   *     reaction, since the event
   * @param response from its release to its output, as far as the bound counts it
   */
  public record Share(String task, long waiting, long response) {

    long time() {
      return waiting + response;
    }
  }

  /** Copies the list, and refuses shares that do not add up. */
  public Bound {
    shares = List.copyOf(shares);
    if (shares.stream().mapToLong(Share::time).sum() != time) {
      throw new IllegalArgumentException("shares " + shares + " of " + time + " ns");
    }
  }
}
