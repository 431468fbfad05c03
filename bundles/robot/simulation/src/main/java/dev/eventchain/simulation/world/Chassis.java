package dev.eventchain.simulation.world;

/**
 * What a vehicle has besides its pedals, and how it is placed in its lane at the start.
 *
 * @param wheelbase in m
 * @param maximalSteeringAngle of the front wheels, in rad
 * @param handBrakeDeceleration in m/s2
 * @param drag deceleration by the air for each (m/s)2, in 1/m
 * @param offset of the middle of the front bumper from the centre of the lane at the start, in m,
 *     left is positive
 * @param heading at the start, in rad, left is positive
 */
public record Chassis(
    double wheelbase,
    double maximalSteeringAngle,
    double handBrakeDeceleration,
    double drag,
    double offset,
    double heading) {

  /**
   * A passenger car in the middle of its lane; its drag is part of its coasting. All numbers are
   * assumed, as those of a car of the compact class may be; no source is behind them.
   */
  public static final Chassis USUAL =
      new Chassis(2.7, StrictMath.toRadians(35), 3.0, 0.0, 0.0, 0.0);

  /** From the rear axle, which the motion is computed for, to the front bumper, in m. */
  double frontOverhang() {
    return wheelbase + FRONT;
  }

  /** From the front axle to the bumper, in m; assumed. */
  private static final double FRONT = 0.9;

  /** How much the path bends for a position of the steering, -1 (left) to 1 (right), in 1/m. */
  double curvature(double steering) {
    return steering == 0.0 ? 0.0 : -StrictMath.tan(steering * maximalSteeringAngle) / wheelbase;
  }
}
