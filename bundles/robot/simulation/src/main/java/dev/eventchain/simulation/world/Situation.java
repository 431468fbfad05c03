package dev.eventchain.simulation.world;

import java.util.List;

/**
 * Initial state of a scenario: the vehicle, its driver, the road, and all actors on it. Immutable.
 */
public record Situation(EgoVehicle ego, HumanDriver driver, Road road, List<Actor> actors) {

  public Situation {
    actors = List.copyOf(actors);
  }

  /** Returns a situation on a straight road, with a driver who keeps the speed. */
  public static Situation straight(EgoVehicle ego, List<Actor> actors) {
    SpeedProfile speed = new SpeedProfile(ego.speed(), List.of());
    LateralProfile line = new LateralProfile(ego.chassis().offset(), List.of());
    return new Situation(ego, new HumanDriver(speed, line, false), Road.STRAIGHT, actors);
  }
}
