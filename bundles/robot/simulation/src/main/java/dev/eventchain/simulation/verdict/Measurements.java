package dev.eventchain.simulation.verdict;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Measurements of the nodes, over all scenarios. Times are in ms of simulated time and the same in
 * every run, except those of the host.
 *
 * @param runId a digest, the same for equal measurements
 * @param firstNode the node that reads the sensor's samples; empty if no node does
 * @param lastNode the node that writes the commands; empty if no node does
 * @param nodes one for each node, in chain order; empty if the nodes run elsewhere, so that their
 *     activations are not visible
 * @param flow the message flow; empty if the nodes run elsewhere
 */
public record Measurements(
    String runId, String firstNode, String lastNode, List<Node> nodes, MessageFlow flow) {

  /** Copies the lists. */
  public Measurements {
    nodes = List.copyOf(nodes);
  }

  /**
   * A distribution. Percentiles are values that occurred (nearest rank).
   *
   * @param count number of values, at least 1
   * @param mean the arithmetic mean: the means of parts add up to that of the whole
   */
  public record Statistics(
      long count, double minimum, double mean, double median, double percentile99, double maximum) {

    /** Returns the distribution of some values; empty if there is none. */
    public static Optional<Statistics> of(double[] values) {
      if (values.length == 0) {
        return Optional.empty();
      }
      double[] sorted = values.clone();
      Arrays.sort(sorted);
      return Optional.of(
          new Statistics(
              sorted.length,
              sorted[0],
              Arrays.stream(sorted).average().orElseThrow(),
              rank(sorted, 0.5),
              rank(sorted, 0.99),
              sorted[sorted.length - 1]));
    }

    /** Returns the distribution of values that are all larger by a number. */
    Statistics later(double by) {
      return new Statistics(
          count, minimum + by, mean + by, median + by, percentile99 + by, maximum + by);
    }

    private static double rank(double[] sorted, double part) {
      return sorted[(int) Math.max(0, Math.ceil(part * sorted.length) - 1)];
    }
  }

  /**
   * Measurements of one node; a distribution without values is empty.
   *
   * @param name the node's name in the model
   * @param activations number of activations
   * @param period between two activations
   * @param jitter deviation of each period from the nominal one
   * @param executionTime of one activation
   * @param hostExecutionTime of one activation on the machine that simulated; differs from run to
   *     run
   */
  public record Node(
      String name,
      int activations,
      Optional<Statistics> period,
      Optional<Statistics> jitter,
      Optional<Statistics> executionTime,
      Optional<Statistics> hostExecutionTime) {

    /**
     * Returns the ratio of the median on this machine to the execution time of the model. Far above
     * 1, the model is probably too optimistic; it decides nothing, since this machine is not the
     * vehicle's.
     *
     * @return empty if the model states no execution time, or nothing was executed
     */
    public OptionalDouble timesWorstCase() {
      double declared = executionTime.map(Statistics::maximum).orElse(0.0);
      return declared > 0 && hostExecutionTime.isPresent()
          ? OptionalDouble.of(hostExecutionTime.get().median() / declared)
          : OptionalDouble.empty();
    }
  }
}
