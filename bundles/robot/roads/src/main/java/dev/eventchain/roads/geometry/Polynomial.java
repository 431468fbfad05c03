package dev.eventchain.roads.geometry;

import java.util.Arrays;

/**
 * A curve {@code (u(p), v(p))} of two cubic polynomials, by its arc length. The arc length is
 * stretched to the length that the file states, so that the curve ends where the next one begins.
 */
final class Polynomial implements PlanCurve {

  private static final int PANELS = 32;

  private final Cubic u;
  private final Cubic v;
  private final double panel;
  private final double scale;

  /** Own arc lengths at the ends of panels. */
  private final double[] lengths = new double[PANELS + 1];

  /**
   * Creates a curve.
   *
   * @param range the parameter at the end, above 0
   * @param length the stated arc length, above 0, in m
   */
  Polynomial(Cubic u, Cubic v, double range, double length) {
    this.u = u;
    this.v = v;
    this.panel = range / PANELS;
    for (int i = 0; i < PANELS; i++) {
      lengths[i + 1] = lengths[i] + Quadrature.integral(this::speed, i * panel, (i + 1) * panel);
    }
    this.scale = lengths[PANELS] / length;
  }

  /**
   * Returns the curve {@code v(u)} of a stated arc length, whose end in u is found by Newton's
   * method.
   */
  static Polynomial overAbscissa(Cubic v, double length) {
    Cubic u = new Cubic(0, 1, 0, 0);
    double range = length;
    for (int i = 0; i < 20; i++) {
      Polynomial tried = new Polynomial(u, v, range, length);
      double error = tried.ownLength() - length;
      if (Math.abs(error) < 1e-10 * length) {
        return tried;
      }
      range = Math.max(range / 2, range - error / tried.speed(range));
    }
    return new Polynomial(u, v, range, length);
  }

  /** Returns the arc length before it is stretched. */
  double ownLength() {
    return lengths[PANELS];
  }

  private double speed(double p) {
    return StrictMath.hypot(u.at(p, 1), v.at(p, 1));
  }

  /** Returns the parameter at an arc length of its own. */
  private double parameter(double own) {
    int found = Arrays.binarySearch(lengths, own);
    int i = Math.max(0, Math.min(PANELS - 1, found < 0 ? -found - 2 : found));
    double from = i * panel;
    double p = from + (own - lengths[i]) / Math.max(speed(from), 1e-12);
    for (int round = 0; round < 8; round++) {
      double error = lengths[i] + Quadrature.integral(this::speed, from, p) - own;
      p -= error / Math.max(speed(p), 1e-12);
      if (Math.abs(error) < 1e-11) {
        break;
      }
    }
    return p;
  }

  @Override
  public PlanPoint at(double along) {
    double p = parameter(along * scale);
    double step = panel / 100;
    double sharpness =
        (curvature(p + step) - curvature(p - step)) / (2 * step * Math.max(speed(p), 1e-12));
    double heading = StrictMath.atan2(v.at(p, 1), u.at(p, 1));
    return new PlanPoint(u.at(p, 0), v.at(p, 0), heading, curvature(p), sharpness);
  }

  private double curvature(double p) {
    double cross = u.at(p, 1) * v.at(p, 2) - v.at(p, 1) * u.at(p, 2);
    return cross / Math.max(StrictMath.pow(speed(p), 3), 1e-12);
  }
}
