package dev.eventchain.simulation.world;

import java.util.List;

/**
 * What happens to an input in the course of a scenario.
 *
 * @param steps in the order of time, the first one at the start
 */
public record Script(List<Step> steps) {

  /** From a time on, in ns, the input has a value, in coherent units. */
  public record Step(long time, double value) {}

  public Script {
    steps = List.copyOf(steps);
  }

  /** The value at a time, in ns. */
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
