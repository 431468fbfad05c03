package dev.eventchain.simulation.sensor;

import dev.eventchain.simulation.world.Body;
import dev.eventchain.simulation.world.Road;

/** A box in the rotated frame of the lidar. */
final class LidarBox {

  private final double x;
  private final double y;
  private final double cos;
  private final double sin;
  private final double halfLength;
  private final double halfWidth;
  private final double bottom;
  private final double top;
  private double leftmost = Double.NEGATIVE_INFINITY;
  private double rightmost = Double.POSITIVE_INFINITY;
  private boolean beside;

  LidarBox(Body body, double x, double y, Road.Place lidar, double aboveRoad) {
    double turned = body.place().heading() - lidar.heading();
    this.cos = StrictMath.cos(turned);
    this.sin = StrictMath.sin(turned);
    // the lidar in the frame of the box
    this.x = -(x * cos + y * sin);
    this.y = x * sin - y * cos;
    this.halfLength = body.length() / 2;
    this.halfWidth = body.width() / 2;
    this.bottom = body.bottom() - aboveRoad;
    this.top = body.top() - aboveRoad;
    for (int corner = 0; corner < 4; corner++) {
      double along = (corner & 1) == 0 ? halfLength : -halfLength;
      double aside = (corner & 2) == 0 ? halfWidth : -halfWidth;
      double ahead = x + along * cos - aside * sin;
      double left = y + along * sin + aside * cos;
      beside |= ahead <= 0.0;
      double azimuth = StrictMath.atan2(left, ahead);
      leftmost = Math.max(leftmost, azimuth);
      rightmost = Math.min(rightmost, azimuth);
    }
  }

  /** Returns whether a part of it is not ahead of the lidar. */
  boolean beside() {
    return beside;
  }

  double leftmost() {
    return leftmost;
  }

  double rightmost() {
    return rightmost;
  }

  /**
   * Returns the distance at which a ray enters it: after the last of its entries into the three
   * slabs.
   */
  double distance(double dx, double dy, double dz) {
    double along = dx * cos + dy * sin;
    double aside = dy * cos - dx * sin;
    double enter = entry(-halfLength - x, halfLength - x, along);
    enter = Math.max(enter, entry(-halfWidth - y, halfWidth - y, aside));
    enter = Math.max(enter, entry(bottom, top, dz));
    double exit = -entry(x - halfLength, x + halfLength, along);
    exit = Math.min(exit, -entry(y - halfWidth, y + halfWidth, aside));
    exit = Math.min(exit, -entry(-top, -bottom, dz));
    return enter <= exit && enter > 0.0 ? enter : Double.POSITIVE_INFINITY;
  }

  /**
   * Returns the distance at which a ray enters a slab; infinite if it runs outside in parallel,
   * negatively infinite if inside.
   */
  private static double entry(double low, double high, double direction) {
    if (direction == 0.0) {
      return low <= 0.0 && high >= 0.0 ? Double.NEGATIVE_INFINITY : Double.POSITIVE_INFINITY;
    }
    return Math.min(low / direction, high / direction);
  }
}
