package dev.eventchain.pipeline.results;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * An end-to-end latency with its upper bound for all phases, and what was measured of it. All times
 * are in ms; what is not known is empty.
 *
 * @param constraint the name of the latency constraint; empty for the latency of the whole chain
 * @param type {@code reaction} or {@code data age}
 * @param maximum what the constraint allows
 * @param assumes the method of the bound and its assumptions
 * @param known what a bound is at least, by the times that are known: the bound in simulated time,
 *     where a component without a worst case takes none
 * @param before what passes before the first component starts and counts
 * @param parts of the bound on the slowest path, in the order of the data
 * @param unknown what would be needed for a bound
 * @param aligned the bound if the timers of that path were released one after the other
 * @param measured the scenario with the longest time
 * @param delayed the scenarios, with the latency of the chain at {@code known}; none of a
 *     constraint
 */
public record BoundedLatency(
    Optional<String> constraint,
    String type,
    String first,
    String last,
    OptionalDouble maximum,
    OptionalDouble bound,
    Optional<String> assumes,
    double known,
    double before,
    List<Part> parts,
    List<String> unknown,
    Optional<Aligned> aligned,
    Optional<Measured> measured,
    List<DelayedScenario> delayed) {

  /** Copies the lists. */
  public BoundedLatency {
    parts = List.copyOf(parts);
    unknown = List.copyOf(unknown);
    delayed = List.copyOf(delayed);
  }

  /**
   * Part of a component in a bound.
   *
   * @param percent of the bound
   * @param period of its timer, if the bound depends on it
   * @param saved what the bound falls by if it is executed twice as often
   * @param largest the largest period with which the constraint still holds for certain
   */
  public record Part(
      String component,
      double waiting,
      double execution,
      double percent,
      OptionalDouble period,
      OptionalDouble saved,
      OptionalDouble largest) {}

  /**
   * Timers of one clock.
   *
   * @param bound the most on all paths
   * @param releases in the order of the data, those of the slowest path first
   */
  public record Aligned(double bound, List<Release> releases) {

    /** Copies the list. */
    public Aligned {
      releases = List.copyOf(releases);
    }
  }

  /** The first release of a component's timer. */
  public record Release(String component, double phase) {}

  /**
   * The longest measured time, of messages only.
   *
   * @param parts what it consists of; empty for the latency of the chain
   */
  public record Measured(String scenario, double longest, List<MeasuredPart> parts) {

    /** Copies the list. */
    public Measured {
      parts = List.copyOf(parts);
    }
  }

  /** Part of a component in a measured time. */
  public record MeasuredPart(String component, double waiting, double execution) {}
}
