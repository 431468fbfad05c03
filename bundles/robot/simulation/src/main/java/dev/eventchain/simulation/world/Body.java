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

  /** Returns the distance of two boxes seen from above, in m; 0 if they touch or overlap. */
  public double distance(Body other) {
    return separation(other) <= 0.0 ? 0.0 : Math.min(toCorners(other), other.toCorners(this));
  }

  /** Returns the distance of the nearest corner of another box that this one does not hold. */
  private double toCorners(Body other) {
    double nearest = Double.POSITIVE_INFINITY;
    for (int end = -1; end <= 1; end += 2) {
      for (int side = -1; side <= 1; side += 2) {
        Road.Place corner = other.corner(end, side);
        double cos = StrictMath.cos(place.heading());
        double sin = StrictMath.sin(place.heading());
        double x = corner.x() - place.x();
        double y = corner.y() - place.y();
        double ahead = Math.max(0.0, Math.abs(x * cos + y * sin) - length / 2);
        double aside = Math.max(0.0, Math.abs(y * cos - x * sin) - width / 2);
        nearest = Math.min(nearest, StrictMath.hypot(ahead, aside));
      }
    }
    return nearest;
  }

  /** Returns a corner: at the front or the rear (1, -1), on the left or the right (1, -1). */
  private Road.Place corner(int end, int side) {
    double cos = StrictMath.cos(place.heading());
    double sin = StrictMath.sin(place.heading());
    double ahead = end * length / 2;
    double left = side * width / 2;
    return new Road.Place(
        place.x() + ahead * cos - left * sin,
        place.y() + ahead * sin + left * cos,
        place.heading());
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
