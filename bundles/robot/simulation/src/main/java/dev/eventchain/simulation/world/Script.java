package dev.eventchain.simulation.world;

import java.util.List;

/**
 * Script of an input in a scenario.
 *
 * @param steps in the order of time, the first one at the start
 */
public record Script(List<Step> steps) {

  /** A value of the input, in coherent units, from a time on, in ns. */
  public record Step(long time, double value) {}

  public Script {
    steps = List.copyOf(steps);
  }

  /** Returns the value at a time, in ns. */
  public double at(long time) {
    double value = steps.get(0).value();
    for (Step step : steps) {
      if (step.time() > time) {
        break;
      }
      value = step.value();
    }
    return value;
  }
}
