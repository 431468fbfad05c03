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

  /** The part of a ray between two parallel planes, from its entry to its exit. */
  record Span(double enter, double exit) {}

  /** Returns the part of rays with this slope that is between its bottom and its top. */
  Span between(double dz) {
    if (dz == 0.0) {
      return bottom <= 0.0 && top >= 0.0
          ? new Span(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY)
          : new Span(Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY);
    }
    return new Span(Math.min(bottom / dz, top / dz), Math.max(bottom / dz, top / dz));
  }

  /**
   * Returns the distance at which a ray enters it: after the last of its entries into the three
   * slabs; infinite if it does not, or not before the nearest echo so far.
   *
   * @param vertical the part of the ray between its bottom and its top
   */
  double distance(double dx, double dy, Span vertical, double nearest) {
    double along = dx * cos + dy * sin;
    double aside = dy * cos - dx * sin;
    boolean passesAlong = along == 0.0 && Math.abs(x) > halfLength;
    boolean passesAside = aside == 0.0 && Math.abs(y) > halfWidth;
    if (passesAlong || passesAside) {
      return Double.POSITIVE_INFINITY;
    }
    double enter = vertical.enter();
    double exit = vertical.exit();
    if (along != 0.0) {
      double rear = (-halfLength - x) / along;
      double front = (halfLength - x) / along;
      enter = later(enter, rear < front ? rear : front);
      exit = earlier(exit, rear < front ? front : rear);
    }
    if (enter >= nearest) {
      return Double.POSITIVE_INFINITY;
    }
    if (aside != 0.0) {
      double right = (-halfWidth - y) / aside;
      double left = (halfWidth - y) / aside;
      enter = later(enter, right < left ? right : left);
      exit = earlier(exit, right < left ? left : right);
    }
    return enter <= exit && enter > 0.0 ? enter : Double.POSITIVE_INFINITY;
  }

  private static double later(double one, double other) {
    return one > other ? one : other;
  }

  private static double earlier(double one, double other) {
    return one < other ? one : other;
  }
}
