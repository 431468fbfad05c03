package dev.eventchain.simulation;

/**
 * Another vehicle on the road; it keeps its lane and its speed until it brakes.
 *
 * @param gap from the ego's front bumper to its rear bumper at the start, in m; negative behind
 * @param speed at the start, in m/s
 * @param lateralOffset of its centre line from the ego's, in m, left is positive
 * @param width in m
 * @param height in m
 * @param length in m
 * @param brakesAt time when it begins to brake, in s; infinite if it never does
 * @param deceleration while it brakes, in m/s2
 */
record TargetVehicle(
    double gap,
    double speed,
    double lateralOffset,
    double width,
    double height,
    double length,
    double brakesAt,
    double deceleration) {

  /** A passenger car that keeps its speed. */
  static TargetVehicle passengerCar(double gap, double speed, double lateralOffset) {
    return new TargetVehicle(
        gap, speed, lateralOffset, 1.8, 1.5, 4.5, Double.POSITIVE_INFINITY, 0.0);
  }

  /**
   * Whether the ego would hit it when it drives straight on.
   *
   * @param offset of the ego from the centre of the lane, in m
   */
  boolean inPath(double offset) {
    return Math.abs(lateralOffset - offset) < (EgoVehicle.WIDTH + width) / 2;
  }

  /**
   * Place of its rear bumper after some seconds, in m from where the ego's front bumper started.
   */
  double position(double seconds) {
    double braking = brakingTime(seconds);
    return gap
        + speed * Math.min(seconds, brakesAt)
        + speed * braking
        - 0.5 * deceleration * braking * braking;
  }

  /** Speed after some seconds, in m/s. */
  double speed(double seconds) {
    return Math.max(0.0, speed - deceleration * brakingTime(seconds));
  }

  private double brakingTime(double seconds) {
    double sinceBraking = Math.max(0.0, seconds - brakesAt);
    return deceleration > 0.0 ? Math.min(sinceBraking, speed / deceleration) : sinceBraking;
  }
}
