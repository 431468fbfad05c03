package dev.eventchain.openscenario.storyboard.position;

import dev.eventchain.openscenario.storyboard.scene.Actor;
import dev.eventchain.openscenario.storyboard.world.Box;
import dev.eventchain.openscenario.storyboard.world.EntityState;
import dev.eventchain.openscenario.storyboard.world.Footprint;
import dev.eventchain.openscenario.storyboard.world.LanePoint;
import dev.eventchain.openscenario.storyboard.world.Pose;
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

  /** Returns it after a short time in which it keeps its velocity. */
  public Body after(double time) {
    Pose moved =
        new Pose(
            pose.x() + vx * time,
            pose.y() + vy * time,
            pose.z(),
            pose.heading(),
            pose.pitch(),
            pose.roll());
    return new Body(moved, box, road, vx, vy);
  }
}
