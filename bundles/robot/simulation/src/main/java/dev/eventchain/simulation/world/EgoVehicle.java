package dev.eventchain.simulation.world;

/**
 * The vehicle with the software.
 *
 * <p>Defaults are those of a passenger car with good tyres on a dry road. 9 m/s2 is roughly what
 * the road surface of Euro NCAP's AEB tests allows, a peak braking coefficient of at least 0.9; UN
 * Regulation No. 13-H requires at least 6.43 m/s2. That regulation allows 0.6 s in an emergency
 * until the brake force is reached; delay and build-up, which are assumed, are 0.5 s of them.
 * Coasting, full throttle and the size of the body are assumed, too.
 *
 * @param speed at the start, in m/s
 * @param brakeDelay from a brake or throttle command to the first change of the deceleration, in s
 * @param brakeBuildUp from no to full deceleration, in s; the ramp is linear, also for less
 * @param maximalDeceleration at full brake, in m/s2
 * @param coastingDeceleration of a vehicle whose driver has lifted the throttle pedal, in m/s2
 * @param maximalAcceleration at full throttle, in m/s2
 * @param lidar the mounting and the errors of the lidar
 * @param chassis its properties besides the pedals
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

  /** Height of the body, in m: it passes under higher objects. */
  public static final double HEIGHT = 1.5;

  /** Ground clearance, in m: it drives over lower objects. */
  static final double CLEARANCE = 0.15;

  /**
   * Returns the throttle, 0 to 1, for an acceleration in m/s2; 0 where coasting exceeds it already.
   */
  double throttleFor(double acceleration) {
    double range = coastingDeceleration + maximalAcceleration;
    double pedal = (acceleration + coastingDeceleration) / range;
    return range > 0.0 && pedal > 0.0 ? Math.min(pedal, 1.0) : 0.0;
  }

  /** Returns the brake, 0 to 1, for an acceleration in m/s2; 0 where coasting is enough. */
  double brakeFor(double acceleration) {
    return acceleration < -coastingDeceleration
        ? Math.min(-acceleration / maximalDeceleration, 1.0)
        : 0.0;
  }

  /** Returns a passenger car with the lidar mounting of the AEB example's object detection. */
  public static EgoVehicle withSpeed(double speed) {
    return new EgoVehicle(speed, 0.2, 0.3, 9.0, 0.5, 3.0, LidarSettings.USUAL, Chassis.USUAL);
  }
}
