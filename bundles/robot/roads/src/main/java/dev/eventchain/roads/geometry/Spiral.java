package dev.eventchain.roads.geometry;

/**
 * A clothoid: its curvature changes linearly with the arc length. The integrals of cosine and sine
 * of the heading are computed by quadrature in panels that turn by at most half a radian, where
 * eight nodes reach the precision of {@code double}. Fresnel's series would divide by the change of
 * curvature, which is nearly 0 in files made from measurements.
 */
final class Spiral implements PlanCurve {

  private static final double TURN_OF_A_PANEL = 0.5;

  private final double start;
  private final double sharpness;
  private final double panel;
  private final double[] x;
  private final double[] y;

  /**
   * Creates a clothoid.
   *
   * @param start the curvature at the start, in 1/m
   * @param end the curvature at the end, in 1/m
   * @param length above 0, in m
   */
  Spiral(double start, double end, double length) {
    this.start = start;
    this.sharpness = (end - start) / length;
    double turns = Math.max(Math.abs(start), Math.abs(end)) * length;
    int panels = Math.max(1, (int) Math.ceil(turns / TURN_OF_A_PANEL));
    this.panel = length / panels;
    this.x = new double[panels + 1];
    this.y = new double[panels + 1];
    for (int i = 0; i < panels; i++) {
      x[i + 1] = x[i] + dx(i * panel, (i + 1) * panel);
      y[i + 1] = y[i] + dy(i * panel, (i + 1) * panel);
    }
  }

  private double heading(double along) {
    return (start + sharpness * along / 2) * along;
  }

  private double dx(double from, double to) {
    return Quadrature.integral(u -> StrictMath.cos(heading(u)), from, to);
  }

  private double dy(double from, double to) {
    return Quadrature.integral(u -> StrictMath.sin(heading(u)), from, to);
  }

  @Override
  public PlanPoint at(double along) {
    int i = Math.max(0, Math.min(x.length - 2, (int) (along / panel)));
    return new PlanPoint(
        x[i] + dx(i * panel, along),
        y[i] + dy(i * panel, along),
        heading(along),
        curvatureAt(along),
        sharpness);
  }

  @Override
  public double curvatureAt(double along) {
    return start + sharpness * along;
  }
}
