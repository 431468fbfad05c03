package dev.eventchain.simulation.world;

/** Position and heading of the rear axle, which moves along its heading without slip. */
final class Axle {

  /** Least yaw rate at which the motion is integrated in closed form, in rad/s. */
  private static final double SLOWEST_SPIN = 0.01;

  private final double toBumper;

  /** Its place, offset so that it equals that of the front bumper at heading 0. */
  private double along;

  private double across;
  private double heading;

  private Axle(double toBumper, double along, double across, double heading) {
    this.toBumper = toBumper;
    this.along = along;
    this.across = across;
    this.heading = heading;
  }

  /**
   * Returns the axle of a vehicle at the start, where the middle of its front bumper is at 0.
   *
   * @param toBumper its distance to the front bumper, in m
   * @param offset of the middle of the front bumper from the centre of the lane, in m
   * @param heading in rad
   */
  static Axle start(double toBumper, double offset, double heading) {
    Axle axle = new Axle(toBumper, 0.0, 0.0, heading);
    axle.along = -axle.ahead();
    axle.across = offset - axle.aside();
    return axle;
  }

  Axle copy() {
    return new Axle(toBumper, along, across, heading);
  }

  /** Returns the offset of the front bumper along the road due to the heading. */
  private double ahead() {
    return toBumper * (StrictMath.cos(heading) - 1.0);
  }

  private double aside() {
    return toBumper * StrictMath.sin(heading);
  }

  /** Returns its distance to the front bumper, in m. */
  double toBumper() {
    return toBumper;
  }

  /** Returns the position of the middle of the front bumper, and its heading. */
  Road.Place front() {
    return new Road.Place(along + ahead(), across + aside(), heading);
  }

  /**
   * Moves along an arc.
   *
   * @param way in m, negative backwards
   * @param curvature in 1/m, positive to the left
   */
  void move(double way, double curvature) {
    double before = heading;
    heading += way * curvature;
    if (curvature == 0.0) {
      along += way * StrictMath.cos(heading);
      across += way * StrictMath.sin(heading);
    } else {
      along += (StrictMath.sin(heading) - StrictMath.sin(before)) / curvature;
      across += (StrictMath.cos(before) - StrictMath.cos(heading)) / curvature;
    }
  }

  /**
   * Moves along the heading while that turns: the integral of a velocity that is linear in time. At
   * small yaw rates, in whose squares that loses its digits, the direction is that in the middle,
   * which is as good for at most 10 ms.
   *
   * @param yawRate in rad/s
   * @param from velocity at the start, in m/s, negative backwards
   * @param to velocity at the end
   */
  void swing(double yawRate, double from, double to, double seconds) {
    double before = heading;
    heading += yawRate * seconds;
    if (Math.abs(yawRate) < SLOWEST_SPIN) {
      double way = (from + to) / 2.0 * seconds;
      double middle = (before + heading) / 2.0;
      along += way * StrictMath.cos(middle);
      across += way * StrictMath.sin(middle);
      return;
    }
    double bend = (to - from) / seconds / (yawRate * yawRate);
    double sine = StrictMath.sin(heading);
    double cosine = StrictMath.cos(heading);
    double sineBefore = StrictMath.sin(before);
    double cosineBefore = StrictMath.cos(before);
    along += (to * sine - from * sineBefore) / yawRate + bend * (cosine - cosineBefore);
    across += (from * cosineBefore - to * cosine) / yawRate + bend * (sine - sineBefore);
  }
}
