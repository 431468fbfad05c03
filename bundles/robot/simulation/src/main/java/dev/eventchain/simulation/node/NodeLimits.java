package dev.eventchain.simulation.node;

import java.time.Duration;

/**
 * What foreign code may use before it counts as hanging. Processor time does not depend on what
 * else this machine does.
 *
 * @param processorTime of a component for one call, and of a node between two messages of a sensor
 * @param wallTime on the clock for the same, for code that waits: much longer
 * @param run on the clock for all scenarios together
 */
public record NodeLimits(Duration processorTime, Duration wallTime, Duration run) {

  /** Ten seconds of processor time, a minute for code that waits, an hour for all. */
  public static final NodeLimits DEFAULT =
      new NodeLimits(Duration.ofSeconds(10), Duration.ofMinutes(1), Duration.ofHours(1));
}
