package dev.eventchain.openscenario.storyboard.scene;

import dev.eventchain.openscenario.storyboard.world.EntityState;

/**
 * Movement of an entity so far.
 *
 * @param travelled the length of its way, in m, jumps left out
 * @param standing for how long it has been standing, in s; negative while it moves
 * @param offRoad for how long it has been off the roads, in s; negative on a road
 * @param atEnd for how long it has been at the end of a road, in s; negative elsewhere
 */
public record Odometer(double travelled, double standing, double offRoad, double atEnd) {

  /** That of an entity of which nothing is known. */
  static final Odometer START = new Odometer(0, -1, -1, -1);

  /** Speed up to which an entity stands, in m/s. */
  private static final double STANDING = 1e-3;

  Odometer after(double distance, EntityState state, boolean end, double dt) {
    return new Odometer(
        travelled + Math.abs(distance),
        since(standing, stands(state), dt),
        since(offRoad, state.road().isEmpty(), dt),
        since(atEnd, end, dt));
  }

  /** Returns it at a moment at which the entity is placed, or gets another speed. */
  Odometer at(EntityState state) {
    return new Odometer(
        travelled,
        since(standing, stands(state), 0),
        since(offRoad, state.road().isEmpty(), 0),
        atEnd);
  }

  private static boolean stands(EntityState state) {
    return Math.abs(state.speed()) <= STANDING;
  }

  private static double since(double before, boolean now, double dt) {
    if (!now) {
      return -1;
    }
    return before < 0 ? 0 : before + dt;
  }
}
