package dev.eventchain.simulation.stage;

import dev.eventchain.openscenario.storyboard.world.EntityState;
import dev.eventchain.openscenario.storyboard.world.Pose;
import dev.eventchain.simulation.world.Road;

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

  /** Returns the middle of a box that is ahead of an entity's reference point, in the world. */
  Road.Place middle(EntityState state, double ahead, double left) {
    return toWorld(state.pose().moved(ahead, left));
  }
}
