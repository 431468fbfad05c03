package dev.eventchain.simulation.stage;

import dev.eventchain.openscenario.storyboard.world.EntityState;
import dev.eventchain.openscenario.storyboard.world.Pose;
import dev.eventchain.simulation.world.Road;
import dev.eventchain.simulation.world.Track;

/**
 * The plane of the world in that of the road map: its origin is a point of the map, with its x axis
 * in a direction.
 *
 * @param x of the origin in the map, in m
 * @param y likewise
 * @param heading of the x axis in the map, in rad
 */
record Frame(double x, double y, double heading) {

  /** Returns a place of the map in the world. */
  Road.Place toWorld(Pose pose) {
    double cos = StrictMath.cos(heading);
    double sin = StrictMath.sin(heading);
    double east = pose.x() - x;
    double north = pose.y() - y;
    return new Road.Place(
        east * cos + north * sin, north * cos - east * sin, pose.heading() - heading);
  }

  /** Returns a place of the world on the map. */
  Pose toMap(Road.Place place) {
    double cos = StrictMath.cos(heading);
    double sin = StrictMath.sin(heading);
    return Pose.flat(
        x + place.x() * cos - place.y() * sin,
        y + place.x() * sin + place.y() * cos,
        place.heading() + heading);
  }

  /**
   * Returns the middle of an entity's box in the world.
   *
   * @param ahead of the reference point, in m
   * @param left of it likewise
   */
  Track.Moment moment(EntityState state, double ahead, double left) {
    double cos = StrictMath.cos(heading);
    double sin = StrictMath.sin(heading);
    // The middle also turns around the reference point.
    double course = state.pose().heading();
    double vx =
        state.vx()
            - state.yawRate() * (ahead * StrictMath.sin(course) + left * StrictMath.cos(course));
    double vy =
        state.vy()
            + state.yawRate() * (ahead * StrictMath.cos(course) - left * StrictMath.sin(course));
    return new Track.Moment(
        toWorld(state.pose().moved(ahead, left)), vx * cos + vy * sin, vy * cos - vx * sin);
  }
}
