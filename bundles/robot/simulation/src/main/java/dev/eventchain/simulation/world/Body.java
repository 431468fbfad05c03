package dev.eventchain.simulation.world;

import dev.eventchain.roads.ground.Rectangle;

/**
 * A solid box that stands or hangs upright over the road.
 *
 * @param place of its middle, with the direction of its front
 * @param length in m
 * @param width in m
 * @param bottom above the road, in m
 * @param top above the road, in m
 * @param intensity of a lidar's echo from it, 0 to 1
 */
public record Body(
    Road.Place place, double length, double width, double bottom, double top, float intensity) {

  /** Returns what it covers, seen from above. */
  public Rectangle covered() {
    return new Rectangle(place.x(), place.y(), place.heading(), length, width);
  }

  /**
   * Returns the distance of two boxes seen from above along one of the normals of their sides, in
   * m, as {@link Rectangle#separation}.
   */
  public double separation(Body other) {
    return covered().separation(other.covered());
  }

  /** Returns the distance of two boxes seen from above, in m; 0 if they touch or overlap. */
  public double distance(Body other) {
    return covered().distance(other.covered());
  }

  /**
   * Returns the distance from its middle to its farthest point in a direction relative to its own,
   * in m.
   */
  public double extent(double direction) {
    return covered().extent(direction);
  }
}
