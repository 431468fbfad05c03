package dev.eventchain.simulation.world;

import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;

/**
 * Initial state of a scenario: the vehicle, its driver, the road, and all actors on it. Immutable.
 *
 * @param end is true of the trace of the moment at which the scenario ends, before its time
 * @param director who moves the actors; empty if they follow their scripts
 */
public record Situation(
    EgoVehicle ego,
    HumanDriver driver,
    Road road,
    List<Actor> actors,
    Optional<Predicate<Trace>> end,
    Optional<Director.Source> director) {

  /** Creates a situation that lasts as long as its scenario. */
  public Situation(EgoVehicle ego, HumanDriver driver, Road road, List<Actor> actors) {
    this(ego, driver, road, actors, Optional.empty());
  }

  /** Creates a situation in which all follow their scripts. */
  public Situation(
      EgoVehicle ego,
      HumanDriver driver,
      Road road,
      List<Actor> actors,
      Optional<Predicate<Trace>> end) {
    this(ego, driver, road, actors, end, Optional.empty());
  }

  public Situation {
    actors = List.copyOf(actors);
  }

  /** Returns the names of the events that a director lets happen. */
  public List<String> events() {
    return director.map(Director.Source::events).orElse(List.of());
  }

  /** Returns a situation on a straight road, with a driver who keeps the speed. */
  public static Situation straight(EgoVehicle ego, List<Actor> actors) {
    SpeedProfile speed = new SpeedProfile(ego.speed(), List.of());
    LateralProfile line = new LateralProfile(ego.chassis().offset(), List.of());
    return new Situation(ego, new HumanDriver(speed, line, false), Road.straight(), actors);
  }
}
