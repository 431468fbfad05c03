package dev.eventchain.roads.geometry;

/** The curves of OpenDRIVE beside lines and arcs. */
public final class PlanCurves {

  private PlanCurves() {}

  /**
   * Returns a clothoid.
   *
   * @param start the curvature at the start, in 1/m
   * @param end the curvature at the end, in 1/m
   * @param length above 0, in m
   */
  public static PlanCurve spiral(double start, double end, double length) {
    return new Spiral(start, end, length);
  }

  /** Returns {@code v(u)} with a stated arc length. */
  public static PlanCurve cubic(Cubic v, double length) {
    return Polynomial.overAbscissa(v, length);
  }

  /** Returns {@code (u(p), v(p))} for p up to a range, with a stated arc length. */
  public static PlanCurve parametric(Cubic u, Cubic v, double range, double length) {
    return new Polynomial(u, v, range, length);
  }

  /**
   * Returns the length that a curve has by itself; the stated one where the curve follows from it.
   */
  public static double ownLength(PlanCurve curve, double stated) {
    return curve instanceof Polynomial polynomial ? polynomial.ownLength() : stated;
  }
}
