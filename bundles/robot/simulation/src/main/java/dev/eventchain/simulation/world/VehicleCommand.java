package dev.eventchain.simulation.world;

import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Demand of the software on the vehicle.
 *
 * @param throttle 0.0 to 1.0; other values are limited, NaN counts as 0
 * @param brake 0.0 to 1.0, as the software wrote it: other values are limited when it takes effect
 * @param steering -1.0 (left) to 1.0 (right); other values are limited
 * @param handBrake true if it is set
 * @param gear -1 backwards, 0 neutral, 1 forwards
 * @param ignored the demands that the simulated vehicle ignores, in words; empty if there are none
 * @param steers true if the software steers, so that a steering of 0 is a command as well
 * @param motor the speed that the vehicle keeps by itself; empty if the software has the pedals
 */
public record VehicleCommand(
    double throttle,
    double brake,
    double steering,
    boolean handBrake,
    int gear,
    String ignored,
    boolean steers,
    Optional<Motor> motor) {

  /**
   * Motion that the vehicle keeps by itself.
   *
   * @param speed in m/s, negative backwards
   * @param yawRate in rad/s, left is positive; empty if the software does not turn the vehicle
   * @param isRenewed whether a message has just said so
   */
  public record Motor(double speed, OptionalDouble yawRate, boolean isRenewed) {}

  /** Maximum rounding error of a float32 acceleration, in m/s2. */
  private static final double ROUNDING = 1e-3;

  /** Returns a command to brake only. */
  public static VehicleCommand brake(double pedal) {
    return pedals(0.0, pedal);
  }

  /** Returns a command to drive only. */
  public static VehicleCommand drive(double pedal) {
    return pedals(pedal, 0.0);
  }

  /** Returns a command for the pedals that keeps the initial state of everything else. */
  static VehicleCommand pedals(double throttle, double brake) {
    return new VehicleCommand(throttle, brake, 0.0, false, 1, "", false, Optional.empty());
  }

  /**
   * Returns the command of software that demands nothing.
   *
   * @param steers true if it steers, and so holds the wheels straight
   */
  public static VehicleCommand idle(boolean steers) {
    return new VehicleCommand(0.0, 0.0, 0.0, false, 1, "", steers, Optional.empty());
  }

  /** Returns the command of demands that are all new. */
  public static VehicleCommand of(Map<Actuator, Double> demands, EgoVehicle vehicle) {
    return of(demands, vehicle, true);
  }

  /**
   * Returns the command that results from the values in force.
   *
   * @param demands in the units of the actuators; 0 by default
   * @param vehicle converts an acceleration into positions of its pedals
   * @param isRenewed whether a demand of a speed is new
   */
  public static VehicleCommand of(
      Map<Actuator, Double> demands, EgoVehicle vehicle, boolean isRenewed) {
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
        ignored(demands, vehicle, throttle, steering),
        demands.containsKey(Actuator.STEERING)
            || demands.containsKey(Actuator.STEERING_ANGLE)
            || demands.containsKey(Actuator.YAW_RATE),
        motor(demands, isRenewed));
  }

  /** Returns the motion that the vehicle is to keep; what is no number counts as 0. */
  private static Optional<Motor> motor(Map<Actuator, Double> demands, boolean isRenewed) {
    if (!demands.containsKey(Actuator.SPEED)) {
      return Optional.empty();
    }
    OptionalDouble yawRate =
        demands.containsKey(Actuator.YAW_RATE)
            ? OptionalDouble.of(finite(demands.get(Actuator.YAW_RATE)))
            : OptionalDouble.empty();
    return Optional.of(new Motor(finite(demands.get(Actuator.SPEED)), yawRate, isRenewed));
  }

  private static double finite(double demand) {
    return Double.isFinite(demand) ? demand : 0.0;
  }

  private static double of(Map<Actuator, Double> demands, Actuator actuator) {
    return demands.getOrDefault(actuator, 0.0);
  }

  /** Returns the demands that the vehicle cannot meet, such as a throttle of 2. */
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
    double speed = of(demands, Actuator.SPEED);
    double yawRate = of(demands, Actuator.YAW_RATE);
    double most = vehicle.chassis().maximalYawRate(speed) + ROUNDING;
    if (!Double.isFinite(speed) || !(Math.abs(yawRate) <= most)) {
      return "yaw_rate " + yawRate + " at speed " + speed;
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

  /** Returns whether it turns the vehicle. */
  boolean turns() {
    return limitedSteering() != 0.0
        || motor.filter(it -> it.yawRate().orElse(0.0) != 0.0).isPresent();
  }

  private static double limited(double demand) {
    return demand > 0.0 ? Math.min(demand, 1.0) : 0.0;
  }
}
