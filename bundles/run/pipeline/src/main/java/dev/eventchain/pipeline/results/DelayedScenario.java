package dev.eventchain.pipeline.results;

import java.util.List;
import java.util.OptionalDouble;

/**
 * A scenario that was driven again with the latency of the chain at its bound: all messages from
 * the world came later by what the bound is above the longest time that was measured in it.
 *
 * @param scenario its name
 * @param longest the longest time that was measured, in ms
 * @param delay what was added, in ms
 * @param speed the highest speed of the vehicle without the delay, in m/s
 * @param metres the way at that speed during the delay, in m
 * @param outcome {@code passed}, {@code failed}, {@code untested} or {@code error}
 * @param reason why it did not pass; empty if it did
 * @param impact the speed of an impact, in m/s; empty if there was none
 */
public record DelayedScenario(
    String scenario,
    double longest,
    double delay,
    double speed,
    double metres,
    String outcome,
    String reason,
    OptionalDouble impact,
    List<Margin> margins) {

  /** Copies the list. */
  public DelayedScenario {
    margins = List.copyOf(margins);
  }

  /**
   * The distance of a criterion to its limit, below zero where it is missed.
   *
   * @param before without the delay
   * @param after with it; empty if there is none in that unit, as after an impact
   */
  public record Margin(String criterion, String unit, double before, OptionalDouble after) {}
}
