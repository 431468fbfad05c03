package dev.eventchain.simulation.node;

import java.time.Duration;

/**
 * Limits of user code before it counts as hanging. Processor time is independent of the machine's
 * load.
 *
 * @param processorTime of a component for one call, and of a node between two messages of a sensor
 * @param wallTime wall time for the same, for code that waits: much longer
 * @param run wall time for all scenarios together
 */
public record NodeLimits(Duration processorTime, Duration wallTime, Duration run) {

  /** Ten seconds of processor time, a minute of wall time, an hour for all scenarios. */
  public static final NodeLimits DEFAULT =
      new NodeLimits(Duration.ofSeconds(10), Duration.ofMinutes(1), Duration.ofHours(1));
}
