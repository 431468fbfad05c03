package dev.eventchain.roads.geometry;

/**
 * A point of a curve in the plane.
 *
 * @param x in m
 * @param y in m
 * @param heading of the tangent, in rad
 * @param curvature in 1/m, positive to the left
 * @param sharpness the change of curvature, in 1/m2
 */
public record PlanPoint(double x, double y, double heading, double curvature, double sharpness) {

  /** Returns the point in the frame of another one, of which this one is relative. */
  PlanPoint placed(double originX, double originY, double originHeading) {
    double cos = StrictMath.cos(originHeading);
    double sin = StrictMath.sin(originHeading);
    return new PlanPoint(
        originX + x * cos - y * sin,
        originY + x * sin + y * cos,
        originHeading + heading,
        curvature,
        sharpness);
  }
}
