package dev.eventchain.simulation.world;

/**
 * The vehicle that carries the software.
 *
 * <p>What a scenario leaves open is that of a passenger car with good tyres on a dry road. 9 m/s2
 * is about what the road surface of Euro NCAP's AEB tests gives, a peak braking coefficient of at
 * least 0.9; UN Regulation No. 13-H asks for at least 6.43 m/s2. That regulation allows 0.6 s in an
 * emergency until the brake force has come; delay and build-up, which are assumed, are 0.5 s of
 * them. Coasting, full throttle and the size of the body are assumed, too.
 *
 * @param speed at the start, in m/s
 * @param brakeDelay from a brake or throttle command to the first change of the deceleration, in s
 * @param brakeBuildUp from no to full deceleration, in s; the ramp is linear, also for less
 * @param maximalDeceleration at full brake, in m/s2
 * @param coastingDeceleration of a vehicle whose driver has lifted the throttle pedal, in m/s2
 * @param maximalAcceleration at full throttle, in m/s2
 * @param lidar how it is mounted, and what it gets wrong
 * @param chassis what it has besides its pedals
 */
public record EgoVehicle(
    double speed,
    double brakeDelay,
    double brakeBuildUp,
    double maximalDeceleration,
    double coastingDeceleration,
    double maximalAcceleration,
    LidarSettings lidar,
    Chassis chassis) {

  /** Width of the body, in m. */
  public static final double WIDTH = 1.8;

  /** Length of the body, in m. */
  public static final double LENGTH = 4.5;

  /** Height of the body, in m: what hangs higher is driven under. */
  public static final double HEIGHT = 1.5;

  /** Ground clearance, in m: what is not higher is driven over. */
  static final double CLEARANCE = 0.15;

  /** The throttle, 0 to 1, for an acceleration in m/s2; none where coasting is too much already. */
  double throttleFor(double acceleration) {
    double range = coastingDeceleration + maximalAcceleration;
    double pedal = (acceleration + coastingDeceleration) / range;
    return range > 0.0 && pedal > 0.0 ? Math.min(pedal, 1.0) : 0.0;
  }

  /** The brake, 0 to 1, for an acceleration in m/s2; none where coasting is enough. */
  double brakeFor(double acceleration) {
    return acceleration < -coastingDeceleration
        ? Math.min(-acceleration / maximalDeceleration, 1.0)
        : 0.0;
  }

  /** A passenger car with the mounting that the AEB example's object detection knows. */
  public static EgoVehicle withSpeed(double speed) {
    return new EgoVehicle(speed, 0.2, 0.3, 9.0, 0.5, 3.0, LidarSettings.USUAL, Chassis.USUAL);
  }
}
