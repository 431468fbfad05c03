package dev.eventchain.simulation.verdict;

import java.util.OptionalDouble;

/**
 * Something that happened in the run of a scenario.
 *
 * @param start in s since the start
 * @param end likewise; empty if it happened at once, or had not ended
 */
public record Happened(String name, Kind kind, double start, OptionalDouble end) {

  /** Kind of the event. */
  public enum Kind {
    /** An event of the storyboard. */
    EVENT,
    /** The software took the pedals or the wheel, which the storyboard had until then. */
    TAKEOVER,
    /** The storyboard ended the run. */
    END
  }
}
