package dev.eventchain.roads.geometry;

import java.util.List;

/** A road's line in the plan view, which s is measured along. Immutable. */
public final class ReferenceLine {

  private final double[] starts;
  private final Piece[] pieces;
  private final double end;

  /**
   * A curve at its place.
   *
   * @param start s where it begins, in m
   * @param x of its start, in m
   * @param y of its start, in m
   * @param heading of its start, in rad
   * @param length above 0, in m
   * @param curve the curve from the origin
   */
  public record Piece(
      double start, double x, double y, double heading, double length, PlanCurve curve) {

    /** Returns the point at a distance behind the start. */
    public PlanPoint at(double along) {
      return curve.at(along).placed(x, y, heading);
    }

    /** Returns whether it is a straight line. */
    boolean isStraight() {
      return curve instanceof PlanCurve.Line;
    }
  }

  /**
   * Creates a line.
   *
   * @param pieces in ascending order, at least one
   * @param end the length of the road, in m
   */
  public ReferenceLine(List<Piece> pieces, double end) {
    this.starts = pieces.stream().mapToDouble(Piece::start).toArray();
    this.pieces = pieces.toArray(Piece[]::new);
    this.end = end;
  }

  /** Returns the length, in m. */
  public double length() {
    return end;
  }

  /** Returns the point at s; outside of the road, the tangent's continuation. */
  public PlanPoint at(double s) {
    double inside = Math.max(0, Math.min(end, s));
    PlanPoint point = curveAt(inside);
    double beyond = s - inside;
    return beyond == 0
        ? point
        : new PlanPoint(
            point.x() + beyond * StrictMath.cos(point.heading()),
            point.y() + beyond * StrictMath.sin(point.heading()),
            point.heading(),
            0,
            0);
  }

  /** Returns the curvature at s, in 1/m, positive to the left; 0 outside of the road. */
  public double curvature(double s) {
    int i = Math.max(0, Profile.indexAt(starts, s));
    return s < 0 || s > end ? 0 : pieces[i].curve.curvatureAt(s - starts[i]);
  }

  private PlanPoint curveAt(double s) {
    int i = Math.max(0, Profile.indexAt(starts, s));
    return pieces[i].at(s - starts[i]);
  }

  /** Returns where the curves begin. */
  public double[] starts() {
    return starts.clone();
  }

  /** Returns whether all between two places is one straight line. */
  public boolean isStraight(double from, double to) {
    int i = Math.max(0, Profile.indexAt(starts, from));
    boolean one = i == pieces.length - 1 || starts[i + 1] >= to;
    return one && pieces[i].isStraight();
  }

  /**
   * Returns s of the point within a range that is nearest to a place. The range must not turn by
   * more than a right angle.
   */
  public double nearest(double x, double y, double from, double to) {
    double low = from;
    double high = to;
    if (ahead(x, y, low) <= 0) {
      return low;
    } else if (ahead(x, y, high) >= 0) {
      return high;
    }
    double s = (low + high) / 2;
    for (int i = 0; i < 60 && high - low > 1e-11; i++) {
      PlanPoint point = at(s);
      double dx = x - point.x();
      double dy = y - point.y();
      double cos = StrictMath.cos(point.heading());
      double sin = StrictMath.sin(point.heading());
      double ahead = dx * cos + dy * sin;
      if (Math.abs(ahead) < 1e-12) {
        return s;
      } else if (ahead > 0) {
        low = s;
      } else {
        high = s;
      }
      double slope = 1 - point.curvature() * (dy * cos - dx * sin);
      double next = s + ahead / slope;
      s = slope > 0.05 && next > low && next < high ? next : (low + high) / 2;
    }
    return s;
  }

  private double ahead(double x, double y, double s) {
    PlanPoint point = at(s);
    return (x - point.x()) * StrictMath.cos(point.heading())
        + (y - point.y()) * StrictMath.sin(point.heading());
  }
}
