package dev.eventchain.roads.geometry;

/** A curve in the plane by its arc length, from the origin in the direction of x. Immutable. */
public interface PlanCurve {

  /** Returns the point at an arc length; outside of the curve, its continuation. */
  PlanPoint at(double along);

  /** Returns the curvature at an arc length, in 1/m, positive to the left. */
  default double curvatureAt(double along) {
    return at(along).curvature();
  }

  /** A straight line. */
  record Line() implements PlanCurve {
    @Override
    public PlanPoint at(double along) {
      return new PlanPoint(along, 0, 0, 0, 0);
    }
  }

  /**
   * An arc of a circle.
   *
   * @param curvature in 1/m, positive to the left
   */
  record Arc(double curvature) implements PlanCurve {
    @Override
    public PlanPoint at(double along) {
      double turned = curvature * along;
      // The chord is along * sinc(turned / 2), which has no cancellation for large radii.
      double half = turned / 2;
      double chord = Math.abs(half) < 1e-9 ? along : along * StrictMath.sin(half) / half;
      return new PlanPoint(
          chord * StrictMath.cos(half), chord * StrictMath.sin(half), turned, curvature, 0);
    }
  }
}
