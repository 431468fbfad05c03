package dev.eventchain.simulation.sensor;

import dev.eventchain.simulation.world.Body;
import dev.eventchain.simulation.world.Road;
import java.util.Comparator;
import java.util.List;

/**
 * A box as seen by an observer over the road: everything between two directions relative to the
 * observer's own, in rad, to the left. Boxes do not overlap, and the observer is in none of them.
 */
record Sight(Body body, Road.Place eye, double right, double left) {

  /** Returns the view of a box from a place. */
  static Sight of(Body body, Road.Place eye) {
    double x = body.place().x() - eye.x();
    double y = body.place().y() - eye.y();
    // From outside, a box spans less than half a turn, so that differences from the direction of
    // its middle do not jump.
    double middle = StrictMath.atan2(y, x);
    double right = 0.0;
    double left = 0.0;
    for (int corner = 0; corner < 4; corner++) {
      double along = ((corner & 1) == 0 ? body.length() : -body.length()) / 2;
      double aside = ((corner & 2) == 0 ? body.width() : -body.width()) / 2;
      double cos = StrictMath.cos(body.place().heading());
      double sin = StrictMath.sin(body.place().heading());
      double direction =
          StrictMath.atan2(y + along * sin + aside * cos, x + along * cos - aside * sin);
      double turned = StrictMath.IEEEremainder(direction - middle, 2 * Math.PI);
      right = Math.min(right, turned);
      left = Math.max(left, turned);
    }
    double ahead = StrictMath.IEEEremainder(middle - eye.heading(), 2 * Math.PI);
    return new Sight(body, eye, ahead + right, ahead + left);
  }

  /** Returns whether a part of it is in a view around the observer's direction, in rad. */
  boolean isWithin(double halfView) {
    for (int turn = -1; turn <= 1; turn++) {
      double turned = turn * 2 * Math.PI;
      if (right + turned <= halfView && left + turned >= -halfView) {
        return true;
      }
    }
    return false;
  }

  /**
   * Returns whether it is wholly hidden. Each of its directions must be covered by a nearer box
   * that is not lower, does not hang higher, and is as high as the observer.
   *
   * @param height of the observer over the road, in m
   */
  boolean isHidden(List<Sight> others, double height) {
    List<Sight> before =
        others.stream()
            .filter(each -> each.hides(this, height))
            .sorted(Comparator.comparingDouble(Sight::right))
            .toList();
    double covered = right;
    for (Sight each : before) {
      if (each.right > covered) {
        return false;
      }
      covered = Math.max(covered, each.left);
    }
    return covered >= left;
  }

  /** Returns whether it hides the box behind it, in their common directions. */
  private boolean hides(Sight other, double height) {
    // Then no line of sight passes over or under it to a point between its edges.
    boolean highEnough = body.top() >= Math.max(height, other.body.top());
    boolean lowEnough = body.bottom() <= Math.min(height, other.body.bottom());
    double first = Math.max(right, other.right);
    double last = Math.min(left, other.left);
    // Boxes that do not overlap have the same order of distance in all directions.
    double shared = (first + last) / 2;
    return highEnough && lowEnough && first < last && distance(shared) < other.distance(shared);
  }

  /**
   * Returns the distance at which a line of sight enters the box, in m: after the later entry into
   * its two slabs.
   */
  private double distance(double direction) {
    double turned = eye.heading() + direction - body.place().heading();
    double cos = StrictMath.cos(body.place().heading());
    double sin = StrictMath.sin(body.place().heading());
    double x = eye.x() - body.place().x();
    double y = eye.y() - body.place().y();
    double along = entry(x * cos + y * sin, StrictMath.cos(turned), body.length() / 2);
    double aside = entry(y * cos - x * sin, StrictMath.sin(turned), body.width() / 2);
    return Math.max(along, aside);
  }

  private static double entry(double from, double slope, double half) {
    return slope == 0.0 ? Double.NEGATIVE_INFINITY : (-Math.copySign(half, slope) - from) / slope;
  }
}
