package dev.eventchain.simulation;

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

  /** A command to brake only. */
  static VehicleCommand brake(double pedal) {
    return new VehicleCommand(0.0, pedal, "");
  }

  /** A command to drive only. */
  static VehicleCommand drive(double pedal) {
    return new VehicleCommand(pedal, 0.0, "");
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
