package dev.eventchain.roads.road;

import dev.eventchain.roads.geometry.PlanPoint;
import dev.eventchain.roads.geometry.Profile;
import java.util.List;

/**
 * The surface of a road above its plan view. Lateral coordinates are measured along the tilted
 * surface, as OpenDRIVE defines them.
 */
public final class RoadSurface {

  private final Profile elevation;
  private final Profile superelevation;
  private final Profile leftFall;
  private final Profile rightFall;
  private final List<CrossSection> shape;
  private final boolean plane;

  /**
   * Heights over t at a place, between which is interpolated.
   *
   * @param s in m
   * @param height in m, over t
   */
  public record CrossSection(double s, Profile height) {}

  /**
   * Creates a surface.
   *
   * @param leftFall the angle by which the left side falls to the outside, in rad
   * @param rightFall the same of the right side
   */
  public RoadSurface(
      Profile elevation,
      Profile superelevation,
      Profile leftFall,
      Profile rightFall,
      List<CrossSection> shape) {
    this.elevation = elevation;
    this.superelevation = superelevation;
    this.leftFall = leftFall;
    this.rightFall = rightFall;
    this.shape = List.copyOf(shape);
    this.plane =
        elevation.isZero()
            && superelevation.isZero()
            && leftFall.isZero()
            && rightFall.isZero()
            && shape.isEmpty();
  }

  /** Returns whether its plan view is all there is. */
  boolean isPlane() {
    return plane;
  }

  /**
   * Returns the pose of a point.
   *
   * @param level the distance to the reference line from which on the surface is level
   * @param height of the point above the surface, in m
   */
  Pose pose(PlanPoint line, double s, double t, double level, double height) {
    double cos = StrictMath.cos(line.heading());
    double sin = StrictMath.sin(line.heading());
    if (plane) {
      return new Pose(line.x() - t * sin, line.y() + t * cos, height, line.heading(), 0, 0);
    }
    double slope = elevation.at(s, 1);
    double norm = Math.sqrt(1 + slope * slope);
    double roll = superelevation.at(s) + (t > 0 ? -leftFall.at(s) : rightFall.at(s));
    double tilted = Math.max(-level, Math.min(level, t));
    double own = Math.abs(t) > level ? 0 : roll;
    // Along the normal of the line that has the slope but no tilt; then along the surface's own.
    double raised = height + heightAt(s, tilted);
    double up = tilted * StrictMath.sin(roll) + raised * StrictMath.cos(own);
    double side = tilted * StrictMath.cos(roll) + t - tilted - raised * StrictMath.sin(own);
    return new Pose(
        line.x() - side * sin - up * slope * cos / norm,
        line.y() + side * cos - up * slope * sin / norm,
        elevation.at(s) + up / norm,
        line.heading(),
        -StrictMath.atan(slope),
        own);
  }

  private double heightAt(double s, double t) {
    CrossSection before = null;
    for (CrossSection section : shape) {
      if (section.s > s) {
        return before == null
            ? section.height.at(t)
            : between(before, section, (s - before.s) / (section.s - before.s), t);
      }
      before = section;
    }
    return before == null ? 0 : before.height.at(t);
  }

  private static double between(CrossSection first, CrossSection second, double share, double t) {
    double start = first.height.at(t);
    return start + share * (second.height.at(t) - start);
  }
}
