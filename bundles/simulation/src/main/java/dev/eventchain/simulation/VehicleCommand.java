package dev.eventchain.simulation;

import java.util.List;
import java.util.Map;

/**
 * What the software asks of the vehicle.
 *
 * @param throttle 0.0 to 1.0; what lies outside is limited, what is no number does not drive
 * @param brake 0.0 to 1.0, as the software wrote it: what lies outside is limited where it takes
 *     effect
 * @param ignored what else it asks for and the simulated vehicle does not do, in words; empty if it
 *     asks for nothing else
 */
record VehicleCommand(double throttle, double brake, String ignored) {

  private static final List<Actuator> NOT_SIMULATED =
      List.of(Actuator.STEERING, Actuator.HAND_BRAKE, Actuator.REVERSE, Actuator.MANUAL_GEAR_SHIFT);

  /** A command to brake only. */
  static VehicleCommand brake(double pedal) {
    return new VehicleCommand(0.0, pedal, "");
  }

  /** A command to drive only. */
  static VehicleCommand drive(double pedal) {
    return new VehicleCommand(pedal, 0.0, "");
  }

  /**
   * The command that the values in force amount to.
   *
   * @param demands in the units of the actuators; 0 where there is none
   * @param vehicle that turns an acceleration into positions of its pedals
   */
  static VehicleCommand of(Map<Actuator, Double> demands, EgoVehicle vehicle) {
    double throttle = demands.getOrDefault(Actuator.THROTTLE, 0.0);
    double brake = demands.getOrDefault(Actuator.BRAKE, 0.0);
    String ignored = throttle >= 0.0 && throttle <= 1.0 ? "" : "throttle " + throttle;
    if (demands.containsKey(Actuator.ACCELERATION)) {
      double acceleration = demands.get(Actuator.ACCELERATION);
      ignored = Double.isFinite(acceleration) ? "" : "acceleration " + acceleration;
      throttle = vehicle.throttleFor(acceleration);
      brake = vehicle.brakeFor(acceleration);
    }
    for (Actuator actuator : NOT_SIMULATED) {
      double demand = demands.getOrDefault(actuator, 0.0);
      if (ignored.isEmpty() && demand != 0.0) {
        ignored = actuator.truth() ? actuator.id() : actuator.id() + " " + demand;
      }
    }
    return new VehicleCommand(throttle, brake, ignored);
  }

  double limitedThrottle() {
    return limited(throttle);
  }

  double limitedBrake() {
    return limited(brake);
  }

  private static double limited(double pedal) {
    return pedal > 0.0 ? Math.min(pedal, 1.0) : 0.0;
  }
}
