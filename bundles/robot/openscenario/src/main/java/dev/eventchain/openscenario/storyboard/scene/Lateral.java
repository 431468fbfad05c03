package dev.eventchain.openscenario.storyboard.scene;

import dev.eventchain.openscenario.storyboard.world.EntityState;
import dev.eventchain.openscenario.storyboard.world.LanePoint;
import dev.eventchain.openscenario.storyboard.world.Pose;
import java.util.Optional;

/** Control of the way of an entity. Immutable. */
public interface Lateral {

  /**
   * A step.
   *
   * @param pose at the end of the step
   * @param road where that is on the roads
   * @param course the direction of the way there, without its motion across the way
   * @param across the speed to the left of the course, in m/s
   * @param atEnd whether the road ends there, so that the entity can go no further
   * @param next what decides the next step
   * @param done whether the aim is reached
   */
  record Step(
      Pose pose,
      Optional<LanePoint> road,
      double course,
      double across,
      boolean atEnd,
      Lateral next,
      boolean done) {}

  /**
   * Returns a step from now.
   *
   * @param moved how the entity moves along its way in the step
   */
  Step step(Scene scene, Actor actor, Longitudinal.Step moved, double dt);

  /** Returns the same for an entity that is not where the last step would have had it. */
  Lateral from(Scene scene, EntityState seen);

  /** Returns whether it says where the entity has to be, whatever lanes there are. */
  default boolean isLine() {
    return false;
  }

  /** Returns what the entity does when this is over, by default what it does of itself. */
  default Lateral rest(Scene scene, EntityState state) {
    return KeepLane.of(scene, state);
  }
}
