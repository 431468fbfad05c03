package dev.eventchain.simulation.world;

/**
 * The vehicle with the software.
 *
 * <p>Defaults are those of a passenger car with good tyres on a dry road. 9 m/s2 is roughly what
 * the road surface of Euro NCAP's AEB tests allows, a peak braking coefficient of at least 0.9; UN
 * Regulation No. 13-H requires at least 6.43 m/s2. That regulation allows 0.6 s in an emergency
 * until the brake force is reached; delay and build-up, which are assumed, are 0.5 s of them.
 * Coasting and full throttle are assumed, too.
 *
 * @param speed at the start, in m/s
 * @param brakeDelay from a brake or throttle command to the first change of the deceleration, in s
 * @param brakeBuildUp from no to full deceleration, in s; the ramp is linear, also for less
 * @param maximalDeceleration at full brake, in m/s2
 * @param coastingDeceleration of a vehicle whose driver has lifted the throttle pedal, in m/s2
 * @param maximalAcceleration at full throttle, in m/s2
 * @param lidar the mounting and the errors of the lidar
 * @param chassis its properties besides the pedals
 * @param shape the size of its body
 * @param speedStep how long the speed is constant before it changes at once, in s; 0 for a speed
 *     that changes continuously
 * @param commandTimeout how long a command of a speed holds, in s, before the vehicle stops by
 *     itself; 0 if it holds until the next one
 */
public record EgoVehicle(
    double speed,
    double brakeDelay,
    double brakeBuildUp,
    double maximalDeceleration,
    double coastingDeceleration,
    double maximalAcceleration,
    LidarSettings lidar,
    Chassis chassis,
    Shape shape,
    double speedStep,
    double commandTimeout) {

  /** Creates a vehicle of the usual size, whose speed changes continuously. */
  public EgoVehicle(
      double speed,
      double brakeDelay,
      double brakeBuildUp,
      double maximalDeceleration,
      double coastingDeceleration,
      double maximalAcceleration,
      LidarSettings lidar,
      Chassis chassis) {
    this(
        speed,
        brakeDelay,
        brakeBuildUp,
        maximalDeceleration,
        coastingDeceleration,
        maximalAcceleration,
        lidar,
        chassis,
        Shape.USUAL,
        0.0,
        0.0);
  }

  /**
   * Returns this vehicle at another place in the lane at the start.
   *
   * @param offset left of the lane's centre, in m
   * @param heading to the left, in rad
   */
  public EgoVehicle placed(double offset, double heading) {
    Chassis placed =
        new Chassis(
            chassis.wheelbase(),
            chassis.maximalSteeringAngle(),
            chassis.handBrakeDeceleration(),
            chassis.drag(),
            offset,
            heading,
            chassis.maximalYawRate());
    return new EgoVehicle(
        speed,
        brakeDelay,
        brakeBuildUp,
        maximalDeceleration,
        coastingDeceleration,
        maximalAcceleration,
        lidar,
        placed,
        shape,
        speedStep,
        commandTimeout);
  }

  /** Returns the distance from the rear axle, the reference of the motion, to the bumper, in m. */
  public double axleToBumper() {
    return chassis.wheelbase() + shape.frontOverhang();
  }

  /**
   * Returns the heading, relative to the road at the front bumper, with which it goes steadily
   * through a bend: its rear axle moves along the road, and its bumper is ahead of that on a larger
   * circle about the same centre.
   *
   * @param bend curvature of the road, in 1/m, to the left is positive
   * @param offset of the bumper to the left of the lane's centre, in m
   */
  public double steadyHeading(double bend, double offset) {
    double sine = axleToBumper() * bend / (1.0 - bend * offset);
    return 0.0 - StrictMath.asin(Math.max(-1.0, Math.min(1.0, sine)));
  }

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
