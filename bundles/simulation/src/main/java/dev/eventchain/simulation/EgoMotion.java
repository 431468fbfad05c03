package dev.eventchain.simulation;

/**
 * Where the ego is and how it moves: a point mass whose deceleration follows a demand with a
 * limited slope. Between two changes of the demand the jerk is piecewise constant, so each piece is
 * integrated exactly and the result does not depend on a step size.
 */
final class EgoMotion {

  private final double slope;
  private final double maximalDeceleration;
  private final double coastingDeceleration;
  private double position;
  private double speed;
  private double deceleration;
  private double demand;

  EgoMotion(EgoVehicle vehicle) {
    this.maximalDeceleration = vehicle.maximalDeceleration();
    this.coastingDeceleration = vehicle.coastingDeceleration();
    this.slope =
        vehicle.brakeBuildUp() > 0.0
            ? maximalDeceleration / vehicle.brakeBuildUp()
            : Double.POSITIVE_INFINITY;
    this.speed = vehicle.speed();
  }

  private EgoMotion(EgoMotion other) {
    this.slope = other.slope;
    this.maximalDeceleration = other.maximalDeceleration;
    this.coastingDeceleration = other.coastingDeceleration;
    this.position = other.position;
    this.speed = other.speed;
    this.deceleration = other.deceleration;
    this.demand = other.demand;
  }

  /** The same state, to try out a piece of time. */
  EgoMotion copy() {
    return new EgoMotion(this);
  }

  /** Way of the front bumper since the start, in m. */
  double position() {
    return position;
  }

  /** In m/s, never negative. */
  double speed() {
    return speed;
  }

  /** In m/s2; zero at standstill. */
  double deceleration() {
    return speed > 0.0 ? deceleration : 0.0;
  }

  /**
   * The brake pedal takes effect. The driver holds the speed until the first brake command and
   * lifts the throttle pedal then, so the vehicle coasts when the brake is released.
   *
   * @param pedal 0.0 to 1.0; what lies outside is limited, what is no number does not brake
   */
  void brake(double pedal) {
    double limited = pedal > 0.0 ? Math.min(pedal, 1.0) : 0.0;
    boolean throttle = demand == 0.0 && limited == 0.0;
    demand = throttle ? 0.0 : Math.max(coastingDeceleration, limited * maximalDeceleration);
  }

  /** Moves on for some seconds. */
  void advance(double seconds) {
    double left = seconds;
    while (left > 0.0) {
      double ramp = Math.abs(demand - deceleration) / slope;
      if (ramp == 0.0 || slope == Double.POSITIVE_INFINITY) {
        deceleration = demand;
        integrate(left, 0.0);
        return;
      }
      double piece = Math.min(ramp, left);
      double jerk = Math.copySign(slope, demand - deceleration);
      integrate(piece, jerk);
      deceleration = piece == ramp ? demand : deceleration + jerk * piece;
      left -= piece;
    }
  }

  /** One piece with a constant change of the deceleration, in m/s3. */
  private void integrate(double seconds, double jerk) {
    double moving = speed > 0.0 ? movingTime(seconds, jerk) : 0.0;
    double before = speed;
    position +=
        before * moving
            - deceleration * moving * moving / 2.0
            - jerk * moving * moving * moving / 6.0;
    speed = moving < seconds ? 0.0 : speedAfter(moving, jerk);
  }

  private double speedAfter(double seconds, double jerk) {
    return Math.max(0.0, speed - deceleration * seconds - jerk * seconds * seconds / 2.0);
  }

  /** The part of a piece until standstill; the speed never grows, so bisection finds it. */
  private double movingTime(double seconds, double jerk) {
    if (speedAfter(seconds, jerk) > 0.0) {
      return seconds;
    }
    double moves = 0.0;
    double stands = seconds;
    for (int i = 0; i < 60; i++) {
      double middle = (moves + stands) / 2.0;
      if (speedAfter(middle, jerk) > 0.0) {
        moves = middle;
      } else {
        stands = middle;
      }
    }
    return Math.min(moves, Math.nextDown(seconds));
  }
}
