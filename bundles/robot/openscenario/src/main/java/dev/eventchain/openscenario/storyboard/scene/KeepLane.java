package dev.eventchain.openscenario.storyboard.scene;

import dev.eventchain.openscenario.storyboard.world.Angles;
import dev.eventchain.openscenario.storyboard.world.EntityState;
import dev.eventchain.openscenario.storyboard.world.Pose;
import java.util.Optional;

/**
 * Follows the lane with the offset and the angle to it that an entity has.
 *
 * @param turned the angle of the heading to the way
 * @param atEnd whether it is at the end of the road
 */
public record KeepLane(LaneWay way, double turned, boolean atEnd) implements Lateral {

  /** Angle to a lane up to which an entity follows it; beyond, it goes straight on. */
  private static final double MOST = Math.PI / 4;

  /**
   * Returns what an entity does of itself: it follows the lane that it is on, or goes straight on
   * if it is on none or heads across.
   */
  public static Lateral of(Scene scene, EntityState state) {
    Optional<LaneWay> way = LaneWay.of(scene, state);
    if (way.isPresent()) {
      double turned = Angles.normalized(state.pose().heading() - way.get().pose(scene).heading());
      if (Math.abs(turned) <= MOST) {
        return new KeepLane(way.get(), turned, false);
      }
    }
    return StraightOn.STRAIGHT_ON;
  }

  @Override
  public Step step(Scene scene, Actor actor, Longitudinal.Step moved, double dt) {
    Optional<LaneWay> there = way.moved(scene, moved.distance(), actor.route());
    LaneWay now = there.orElse(way);
    boolean end = there.isEmpty() || (atEnd && moved.distance() == 0);
    Pose lane = now.pose(scene);
    Pose pose = lane.withHeading(lane.heading() + turned);
    return new Step(
        pose,
        Optional.of(now.point()),
        lane.heading(),
        0,
        end,
        new KeepLane(now, turned, end),
        false);
  }

  @Override
  public Lateral from(Scene scene, EntityState seen) {
    return of(scene, seen);
  }
}
