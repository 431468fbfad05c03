package dev.eventchain.roads.ground;

/**
 * A rectangle on the ground, such as what a vehicle covers. Without length and width, it is a
 * point.
 *
 * @param x of its middle, in m
 * @param y of its middle, in m
 * @param heading of its length, in rad, counterclockwise from x
 * @param length in m
 * @param width in m
 */
public record Rectangle(double x, double y, double heading, double length, double width) {

  /** Returns whether two rectangles share a point. */
  public boolean touches(Rectangle other) {
    return separation(other) <= 0.0;
  }

  /**
   * Returns the largest distance along one of the normals of the sides, in m (separating axis
   * theorem), which is never more than the distance; not above 0 if they share a point.
   */
  public double separation(Rectangle other) {
    return Math.max(along(other, heading), other.along(this, other.heading));
  }

  private double along(Rectangle other, double axis) {
    double cos = StrictMath.cos(axis);
    double sin = StrictMath.sin(axis);
    double ahead = Math.abs((other.x - x) * cos + (other.y - y) * sin);
    double aside = Math.abs((other.y - y) * cos - (other.x - x) * sin);
    double turned = other.heading - axis;
    double lengthwise = ahead - length / 2 - other.extent(turned);
    double sideways = aside - width / 2 - other.extent(turned - Math.PI / 2);
    return Math.max(lengthwise, sideways);
  }

  /** Returns the distance, in m; 0 if they share a point. */
  public double distance(Rectangle other) {
    return touches(other) ? 0.0 : Math.min(toCorners(other), other.toCorners(this));
  }

  /**
   * Returns the distance of the nearest corner of another rectangle that this one does not hold.
   */
  private double toCorners(Rectangle other) {
    double cos = StrictMath.cos(heading);
    double sin = StrictMath.sin(heading);
    double otherCos = StrictMath.cos(other.heading);
    double otherSin = StrictMath.sin(other.heading);
    double nearest = Double.POSITIVE_INFINITY;
    for (int end = -1; end <= 1; end += 2) {
      for (int side = -1; side <= 1; side += 2) {
        double forward = end * other.length / 2;
        double left = side * other.width / 2;
        double east = other.x + forward * otherCos - left * otherSin - x;
        double north = other.y + forward * otherSin + left * otherCos - y;
        double ahead = Math.max(0.0, Math.abs(east * cos + north * sin) - length / 2);
        double aside = Math.max(0.0, Math.abs(north * cos - east * sin) - width / 2);
        nearest = Math.min(nearest, StrictMath.hypot(ahead, aside));
      }
    }
    return nearest;
  }

  /**
   * Returns the distance from its middle to its farthest point in a direction relative to its own,
   * in m.
   */
  public double extent(double direction) {
    // Exact along its length, so that what stands along a road has exact ends.
    double cos = direction == 0.0 ? 1.0 : Math.abs(StrictMath.cos(direction));
    double sin = direction == 0.0 ? 0.0 : Math.abs(StrictMath.sin(direction));
    return length / 2 * cos + width / 2 * sin;
  }
}
