package dev.eventchain.simulation.world;

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

  /**
   * Returns the distance of two boxes seen from above, in m: the largest distance along one of the
   * normals of their sides (separating axis theorem), which is never more than the true one; not
   * above 0 if they overlap.
   */
  public double separation(Body other) {
    double first = along(other, place.heading(), length, width);
    double second = other.along(this, other.place.heading(), other.length, other.width);
    return Math.max(first, second);
  }

  private double along(Body other, double axis, double ownLength, double ownWidth) {
    double cos = StrictMath.cos(axis);
    double sin = StrictMath.sin(axis);
    double ahead =
        Math.abs((other.place.x() - place.x()) * cos + (other.place.y() - place.y()) * sin);
    double aside =
        Math.abs((other.place.y() - place.y()) * cos - (other.place.x() - place.x()) * sin);
    double turned = other.place.heading() - axis;
    double lengthwise = ahead - ownLength / 2 - other.extent(turned);
    double sideways = aside - ownWidth / 2 - other.extent(turned - Math.PI / 2);
    return Math.max(lengthwise, sideways);
  }

  /**
   * Returns the distance from its middle to its farthest point in a direction relative to its own,
   * in m.
   */
  public double extent(double direction) {
    return extent(length, width, direction);
  }

  /** Returns the extent of a box with a length and a width. */
  static double extent(double length, double width, double direction) {
    // A multiple of a right angle is exact, so that a box along the road has exact ends.
    double cos = direction == 0.0 ? 1.0 : Math.abs(StrictMath.cos(direction));
    double sin = direction == 0.0 ? 0.0 : Math.abs(StrictMath.sin(direction));
    return length / 2 * cos + width / 2 * sin;
  }
}
