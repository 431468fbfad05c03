package dev.eventchain.simulation.world;

import java.util.Map;

/**
 * What the software asks of the vehicle.
 *
 * @param throttle 0.0 to 1.0; what lies outside is limited, what is not a number does not drive
 * @param brake 0.0 to 1.0, as the software wrote it: what lies outside is limited where it takes
 *     effect
 * @param steering -1.0 (left) to 1.0 (right); what lies outside is limited
 * @param handBrake whether it is set
 * @param gear -1 backwards, 0 neutral, 1 forwards
 * @param ignored what it asks for and the simulated vehicle does not do, in words; empty if it does
 *     everything
 */
public record VehicleCommand(
    double throttle, double brake, double steering, boolean handBrake, int gear, String ignored) {

  /** What a float32 may add to an acceleration, in m/s2. */
  private static final double ROUNDING = 1e-3;

  /** A command to brake only. */
  public static VehicleCommand brake(double pedal) {
    return pedals(0.0, pedal);
  }

  /** A command to drive only. */
  public static VehicleCommand drive(double pedal) {
    return pedals(pedal, 0.0);
  }

  /** A command that leaves everything but the pedals as it is at the start. */
  static VehicleCommand pedals(double throttle, double brake) {
    return new VehicleCommand(throttle, brake, 0.0, false, 1, "");
  }

  /**
   * The command that the values in force amount to.
   *
   * @param demands in the units of the actuators; 0 where there is none
   * @param vehicle that turns an acceleration into positions of its pedals
   */
  public static VehicleCommand of(Map<Actuator, Double> demands, EgoVehicle vehicle) {
    double throttle = of(demands, Actuator.THROTTLE);
    double brake = of(demands, Actuator.BRAKE);
    if (demands.containsKey(Actuator.ACCELERATION)) {
      double acceleration = demands.get(Actuator.ACCELERATION);
      throttle = vehicle.throttleFor(acceleration);
      brake = vehicle.brakeFor(acceleration);
    }
    double steering = of(demands, Actuator.STEERING);
    if (demands.containsKey(Actuator.STEERING_ANGLE)) {
      double angle = demands.get(Actuator.STEERING_ANGLE);
      steering = 0.0 - angle / vehicle.chassis().maximalSteeringAngle();
    }
    boolean backwards =
        of(demands, Actuator.REVERSE) != 0.0 || demands.getOrDefault(Actuator.GEAR, 1.0) < 0.0;
    int gear = backwards ? -1 : demands.getOrDefault(Actuator.GEAR, 1.0) == 0.0 ? 0 : 1;
    return new VehicleCommand(
        throttle,
        brake,
        steering,
        of(demands, Actuator.HAND_BRAKE) != 0.0,
        gear,
        ignored(demands, vehicle, throttle, steering));
  }

  private static double of(Map<Actuator, Double> demands, Actuator actuator) {
    return demands.getOrDefault(actuator, 0.0);
  }

  /** What the vehicle cannot do, such as to drive with a throttle of 2. */
  private static String ignored(
      Map<Actuator, Double> demands, EgoVehicle vehicle, double throttle, double steering) {
    double acceleration = of(demands, Actuator.ACCELERATION);
    if (!(acceleration >= -vehicle.maximalDeceleration() - ROUNDING
        && acceleration <= vehicle.maximalAcceleration() + ROUNDING)) {
      return "acceleration " + acceleration;
    }
    if (!(throttle >= 0.0 && throttle <= 1.0)) {
      return "throttle " + throttle;
    }
    if (!(steering >= -1.0 && steering <= 1.0)) {
      return "steering " + steering;
    }
    return of(demands, Actuator.MANUAL_GEAR_SHIFT) != 0.0 ? Actuator.MANUAL_GEAR_SHIFT.id() : "";
  }

  double limitedThrottle() {
    return limited(throttle);
  }

  double limitedBrake() {
    return limited(brake);
  }

  double limitedSteering() {
    return Math.copySign(limited(Math.abs(steering)), steering);
  }

  private static double limited(double demand) {
    return demand > 0.0 ? Math.min(demand, 1.0) : 0.0;
  }
}
