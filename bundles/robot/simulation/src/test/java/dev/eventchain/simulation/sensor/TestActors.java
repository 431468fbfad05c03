package dev.eventchain.simulation.sensor;

import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.ActorKind;
import dev.eventchain.simulation.world.LateralProfile;
import dev.eventchain.simulation.world.SpeedProfile;
import java.util.List;

/** Actors of the tests of sensors. */
final class TestActors {

  private TestActors() {}

  /** Returns an actor in the own lane that stands. */
  static Actor standing(ActorKind kind, double gap) {
    return moving(kind, gap, 0, 0);
  }

  /**
   * Returns an actor of the usual size of its kind that keeps its speed and its lane.
   *
   * @param gap from the front bumper at the start to its rear, in m
   * @param across left of the own lane's centre, in m
   * @param speed in m/s
   */
  static Actor moving(ActorKind kind, double gap, double across, double speed) {
    return new Actor(
        kind.id(),
        kind,
        kind.size(),
        gap,
        0,
        new SpeedProfile(speed, List.of()),
        new LateralProfile(across, List.of()));
  }
}
