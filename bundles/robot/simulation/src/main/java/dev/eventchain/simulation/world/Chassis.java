package dev.eventchain.simulation.world;

/**
 * Properties of a vehicle besides its pedals, and its position in the lane at the start.
 *
 * @param wheelbase in m
 * @param maximalSteeringAngle of the front wheels, in rad
 * @param handBrakeDeceleration in m/s2
 * @param drag deceleration by the air for each (m/s)2, in 1/m
 * @param offset of the middle of the front bumper from the centre of the lane at the start, in m,
 *     left is positive
 * @param heading at the start, in rad, left is positive
 * @param maximalYawRate of a vehicle that turns without driving, such as a robot with two driven
 *     wheels, in rad/s; 0 for one that is steered by its front wheels
 */
public record Chassis(
    double wheelbase,
    double maximalSteeringAngle,
    double handBrakeDeceleration,
    double drag,
    double offset,
    double heading,
    double maximalYawRate) {

  /**
   * A passenger car in the middle of its lane; its drag is part of its coasting. All numbers are
   * assumptions for a car of the compact class, without a source.
   */
  public static final Chassis USUAL =
      new Chassis(2.7, StrictMath.toRadians(35), 3.0, 0.0, 0.0, 0.0);

  /** Creates the properties of a vehicle that is steered by its front wheels. */
  public Chassis(
      double wheelbase,
      double maximalSteeringAngle,
      double handBrakeDeceleration,
      double drag,
      double offset,
      double heading) {
    this(wheelbase, maximalSteeringAngle, handBrakeDeceleration, drag, offset, heading, 0.0);
  }

  /** Returns whether a speed of 0 lets it turn. */
  public boolean turnsOnTheSpot() {
    return maximalYawRate > 0.0;
  }

  /** Returns the largest yaw rate at a speed in m/s, in rad/s. */
  double maximalYawRate(double speed) {
    return turnsOnTheSpot() ? maximalYawRate : Math.abs(speed) * tightest();
  }

  /** Returns the largest curvature of its path, in 1/m. */
  public double tightest() {
    return curvature(-1.0);
  }

  /** Returns the curvature of the path for a steering position, -1 (left) to 1 (right), in 1/m. */
  double curvature(double steering) {
    return steering == 0.0 ? 0.0 : -StrictMath.tan(steering * maximalSteeringAngle) / wheelbase;
  }
}
