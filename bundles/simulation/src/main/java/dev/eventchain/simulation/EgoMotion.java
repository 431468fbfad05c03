package dev.eventchain.simulation;

/**
 * Where the ego is and how it moves: a point mass whose deceleration follows a demand with a
 * limited slope; an acceleration is a negative one. Between two changes of the demand the jerk is
 * piecewise constant, so each piece is integrated exactly and the result does not depend on a step
 * size.
 */
final class EgoMotion {

  private final double slope;
  private final double maximalDeceleration;
  private final double coastingDeceleration;
  private final double maximalAcceleration;
  private double position;
  private double speed;
  private double deceleration;
  private double demand;

  /** Whether the driver holds the speed, as long as the software asks for nothing. */
  private boolean held = true;

  EgoMotion(EgoVehicle vehicle) {
    this.maximalDeceleration = vehicle.maximalDeceleration();
    this.coastingDeceleration = vehicle.coastingDeceleration();
    this.maximalAcceleration = vehicle.maximalAcceleration();
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
    this.maximalAcceleration = other.maximalAcceleration;
    this.position = other.position;
    this.speed = other.speed;
    this.deceleration = other.deceleration;
    this.demand = other.demand;
    this.held = other.held;
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

  /** In m/s2; zero at standstill, negative while it speeds up. */
  double deceleration() {
    return speed > 0.0 ? deceleration : 0.0;
  }

  /**
   * A command takes effect. The driver holds the speed until the software first asks for throttle
   * or brake, and lifts the pedal then: with neither, the vehicle coasts. Braking wins over
   * driving; the throttle adds to coasting in proportion, up to the maximal acceleration.
   */
  void follow(VehicleCommand command) {
    double brake = command.limitedBrake();
    double throttle = command.limitedThrottle();
    held &= brake == 0.0 && throttle == 0.0;
    if (held) {
      demand = 0.0;
    } else if (brake > 0.0) {
      demand = Math.max(coastingDeceleration, brake * maximalDeceleration);
    } else {
      demand = coastingDeceleration - throttle * (coastingDeceleration + maximalAcceleration);
    }
  }

  /** Moves on for some seconds. */
  void advance(double seconds) {
    double left = seconds;
    while (left > 0.0) {
      // In a piece the deceleration keeps its sign, so that the speed only falls or only grows.
      double target = deceleration * demand < 0.0 ? 0.0 : demand;
      double ramp = Math.abs(target - deceleration) / slope;
      if (slope == Double.POSITIVE_INFINITY || deceleration == demand) {
        deceleration = demand;
        integrate(left, 0.0);
        return;
      }
      double piece = Math.min(ramp, left);
      double jerk = Math.copySign(slope, target - deceleration);
      integrate(piece, jerk);
      deceleration = piece == ramp ? target : deceleration + jerk * piece;
      left -= piece;
    }
  }

  /** One piece with a constant change of the deceleration, in m/s3. */
  private void integrate(double seconds, double jerk) {
    boolean drives = deceleration < 0.0 || (deceleration == 0.0 && jerk < 0.0);
    double moving = drives ? seconds : speed > 0.0 ? movingTime(seconds, jerk) : 0.0;
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

  /** The part of a piece until standstill; the speed does not grow, so bisection finds it. */
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
