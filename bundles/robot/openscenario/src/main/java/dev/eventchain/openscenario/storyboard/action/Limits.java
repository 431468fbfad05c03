package dev.eventchain.openscenario.storyboard.action;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.world.Performance;

/** Dynamic constraints: m/s and m/s2, infinite where nothing is said. */
record Limits(double speed, double acceleration, double deceleration) {

  static Limits of(ScenarioElement constraints) {
    return new Limits(
        constraints.number("maxSpeed", Double.POSITIVE_INFINITY),
        constraints.number("maxAcceleration", Double.POSITIVE_INFINITY),
        constraints.number("maxDeceleration", Double.POSITIVE_INFINITY));
  }

  /** Returns the same, and no more than a vehicle can. */
  Limits within(Performance performance) {
    return new Limits(
        Math.min(speed, performance.maxSpeed()),
        Math.min(acceleration, performance.maxAcceleration()),
        Math.min(deceleration, performance.maxDeceleration()));
  }

  /** Returns the largest change per second from one speed to another one. */
  double rate(double from, double to) {
    return Math.abs(to) >= Math.abs(from) ? acceleration : deceleration;
  }
}
