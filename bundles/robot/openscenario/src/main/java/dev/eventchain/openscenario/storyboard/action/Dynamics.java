package dev.eventchain.openscenario.storyboard.action;

import dev.eventchain.openscenario.document.ScenarioElement;

/**
 * Way in which a value gets to its target.
 *
 * @param dimension {@code time}, {@code rate} or {@code distance}
 * @param value in s, in the value's unit per second, or in m
 * @param within whether the limits of the entity hold
 */
record Dynamics(Shape shape, String dimension, double value, boolean within) {

  static Dynamics of(ScenarioElement dynamics) {
    return new Dynamics(
        Shape.of(dynamics.text("dynamicsShape")),
        dynamics.text("dynamicsDimension"),
        dynamics.number("value"),
        dynamics.optional("followingMode").orElse("position").equals("follow"));
  }

  /** Returns whether the target is reached at once. */
  boolean atOnce() {
    return shape == Shape.STEP || (value == 0 && !dimension.equals("rate"));
  }

  /** Returns the time that a change takes if the value is a time or the largest rate, in s. */
  double duration(double change) {
    return dimension.equals("time") ? value : shape.steepest() * Math.abs(change) / value;
  }
}
