package dev.eventchain.simulation;

import java.util.List;

/**
 * What happens to an input in the course of a scenario.
 *
 * @param steps in the order of time, the first one at the start
 */
record Script(List<Step> steps) {

  /** From a time on, in ns, the input has a value, in coherent units. */
  record Step(long time, double value) {}

  Script {
    steps = List.copyOf(steps);
  }

  /** The value at a time, in ns. */
  double at(long time) {
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
