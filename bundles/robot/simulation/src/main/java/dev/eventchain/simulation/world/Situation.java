package dev.eventchain.simulation.world;

import java.util.List;

/**
 * What a scenario begins with: the vehicle, who drives it, the road, and all others on it.
 * Immutable.
 */
public record Situation(EgoVehicle ego, HumanDriver driver, Road road, List<Actor> actors) {

  public Situation {
    actors = List.copyOf(actors);
  }

  /** On a straight road, with a driver who holds the speed. */
  public static Situation straight(EgoVehicle ego, List<Actor> actors) {
    SpeedProfile speed = new SpeedProfile(ego.speed(), List.of());
    LateralProfile line = new LateralProfile(ego.chassis().offset(), List.of());
    return new Situation(ego, new HumanDriver(speed, line, false), Road.STRAIGHT, actors);
  }
}
