package dev.eventchain.openscenario.storyboard.position;

import dev.eventchain.openscenario.storyboard.scene.Actor;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.world.Box;
import dev.eventchain.openscenario.storyboard.world.EntityState;
import dev.eventchain.openscenario.storyboard.world.Footprint;
import dev.eventchain.openscenario.storyboard.world.LanePoint;
import dev.eventchain.openscenario.storyboard.world.Pose;
import dev.eventchain.openscenario.storyboard.world.RoadMap;
import java.util.List;
import java.util.Optional;

/**
 * Start or end of a distance: an entity, or a position.
 *
 * @param box empty for a position
 * @param vx velocity in the world, in m/s
 * @param vy likewise
 */
public record Body(Pose pose, Optional<Box> box, Optional<LanePoint> road, double vx, double vy) {

  public static Body of(Actor actor) {
    EntityState state = actor.state();
    return new Body(
        state.pose(), Optional.of(actor.entity().box()), state.road(), state.vx(), state.vy());
  }

  public static Body of(Placement place) {
    return new Body(place.pose(), Optional.empty(), place.road(), 0, 0);
  }

  /** Returns what it covers, or its reference point only. */
  Footprint footprint(boolean freespace) {
    return freespace && box.isPresent() ? Footprint.of(pose, box.get()) : Footprint.of(pose);
  }

  /**
   * Returns it after a short time in which it keeps its velocity, along its road if it is on one.
   */
  public Body after(Scene scene, double time) {
    Pose moved =
        new Pose(
            pose.x() + vx * time,
            pose.y() + vy * time,
            pose.z(),
            pose.heading(),
            pose.pitch(),
            pose.roll());
    Optional<LanePoint> there =
        road.map(at -> scene.roads().move(at, true, along(scene, at) * time, List.of()))
            .map(each -> each.map(RoadMap.Moved::point).orElse(road.get()));
    return new Body(moved, box, there, vx, vy);
  }

  /** Returns its speed in the direction of the road's s. */
  private double along(Scene scene, LanePoint point) {
    double heading = scene.roads().pose(scene.roads().road(point)).heading();
    return vx * StrictMath.cos(heading) + vy * StrictMath.sin(heading);
  }
}
