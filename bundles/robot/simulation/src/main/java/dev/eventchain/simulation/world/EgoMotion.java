package dev.eventchain.simulation.world;

/**
 * Where the ego is and how it moves. Along its path it is a point mass whose deceleration follows a
 * demand with a limited slope; an acceleration is a negative one. Between two changes of the demand
 * the jerk is piecewise constant, so each piece is integrated exactly and the result does not
 * depend on a step size; only the drag is held for at most 10 ms. The path is that of a kinematic
 * bicycle (Rajamani, Vehicle Dynamics and Control, 2.2): the rear axle follows an arc, whose
 * curvature is the tangent of the steering angle by the wheelbase, without slip.
 */
public final class EgoMotion {

  private final double slope;
  private final double maximalDeceleration;
  private final double coastingDeceleration;
  private final double maximalAcceleration;
  private final Chassis chassis;

  /** Of the rear axle, whose place is that of the front bumper without a heading. */
  private double along;

  private double across;
  private double heading;
  private double curvature;
  private int direction = 1;
  private VehicleCommand command = VehicleCommand.drive(0.0);
  private double speed;
  private double deceleration;

  /** Whether the driver has the pedals, as long as the software asks for nothing. */
  private boolean held = true;

  /** Whether the driver has the wheel, as long as the software does not steer. */
  private boolean steered = true;

  /** The deceleration that the driver asks for, in m/s2. */
  private double driven;

  public EgoMotion(EgoVehicle vehicle) {
    this.maximalDeceleration = vehicle.maximalDeceleration();
    this.coastingDeceleration = vehicle.coastingDeceleration();
    this.maximalAcceleration = vehicle.maximalAcceleration();
    this.slope =
        vehicle.brakeBuildUp() > 0.0
            ? maximalDeceleration / vehicle.brakeBuildUp()
            : Double.POSITIVE_INFINITY;
    this.speed = vehicle.speed();
    this.chassis = vehicle.chassis();
    this.heading = chassis.heading();
    this.along = -ahead();
    this.across = chassis.offset() - aside();
  }

  private EgoMotion(EgoMotion other) {
    this.slope = other.slope;
    this.maximalDeceleration = other.maximalDeceleration;
    this.coastingDeceleration = other.coastingDeceleration;
    this.maximalAcceleration = other.maximalAcceleration;
    this.chassis = other.chassis;
    this.along = other.along;
    this.across = other.across;
    this.heading = other.heading;
    this.curvature = other.curvature;
    this.direction = other.direction;
    this.speed = other.speed;
    this.deceleration = other.deceleration;
    this.command = other.command;
    this.held = other.held;
    this.steered = other.steered;
    this.driven = other.driven;
  }

  /** The same state, to try out a piece of time. */
  EgoMotion copy() {
    return new EgoMotion(this);
  }

  /** How far the front bumper is beyond the rear axle, but for what it is without a heading. */
  private double ahead() {
    return chassis.frontOverhang() * (StrictMath.cos(heading) - 1.0);
  }

  private double aside() {
    return chassis.frontOverhang() * StrictMath.sin(heading);
  }

  /** Where the middle of the front bumper is, and where it looks. */
  public Road.Place front() {
    return new Road.Place(along + ahead(), across + aside(), heading);
  }

  /** The body. */
  public Body body() {
    return new Body(
        front().ahead(-EgoVehicle.LENGTH / 2),
        EgoVehicle.LENGTH,
        EgoVehicle.WIDTH,
        0.0,
        EgoVehicle.HEIGHT,
        0.0f);
  }

  /** In rad/s, to the left is positive. */
  double yawRate() {
    return velocity() * curvature;
  }

  /** In m/s, never negative. */
  double speed() {
    return speed;
  }

  /** Along its own axis, in m/s; negative backwards. */
  public double velocity() {
    return direction * speed;
  }

  /** In m/s2, of the velocity; zero at standstill, negative while it speeds up. */
  double deceleration() {
    return speed > 0.0 ? direction * deceleration : 0.0;
  }

  /** Whether the driver has the pedals. */
  boolean held() {
    return held;
  }

  /** Whether the driver has the wheel. */
  boolean steered() {
    return steered;
  }

  /** What the driver does with the pedals, as an acceleration in m/s2. */
  void drive(double acceleration) {
    driven = Math.max(-maximalAcceleration, Math.min(maximalDeceleration, -acceleration));
  }

  /** What the driver does with the wheel, as a curvature in 1/m. */
  void steer(double wanted) {
    double tightest = chassis.curvature(-1.0);
    curvature = Math.max(-tightest, Math.min(tightest, wanted));
  }

  /**
   * A command takes effect. The driver has the pedals until the software first asks for throttle,
   * brake, hand brake or another gear, and lifts them then: with none, the vehicle coasts. He has
   * the wheel until the software first steers. Braking wins over driving; the throttle adds to
   * coasting in proportion, up to the maximal acceleration. Another direction is engaged at
   * standstill.
   */
  void follow(VehicleCommand newCommand) {
    command = newCommand;
    steered &= command.limitedSteering() == 0.0;
    if (!steered) {
      curvature = chassis.curvature(command.limitedSteering());
    }
    held &=
        command.limitedBrake() == 0.0
            && command.limitedThrottle() == 0.0
            && !command.handBrake()
            && command.gear() == 1;
  }

  /** The deceleration that the command asks for, in m/s2. */
  private double demand() {
    if (held) {
      return driven;
    }
    double handBrake = command.handBrake() ? chassis.handBrakeDeceleration() : 0.0;
    double braking = Math.max(command.limitedBrake() * maximalDeceleration, handBrake);
    if (braking > 0.0) {
      return Math.max(coastingDeceleration, braking) + drag();
    }
    double throttle = command.gear() == direction ? command.limitedThrottle() : 0.0;
    return coastingDeceleration - throttle * (coastingDeceleration + maximalAcceleration) + drag();
  }

  private double drag() {
    return chassis.drag() * speed * speed;
  }

  /** Moves on for some seconds. */
  void advance(double seconds) {
    if (speed == 0.0 && command.gear() != 0) {
      direction = command.gear();
    }
    double left = seconds;
    double demand = demand();
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
    move(
        before * moving
            - deceleration * moving * moving / 2.0
            - jerk * moving * moving * moving / 6.0);
    speed = moving < seconds ? 0.0 : speedAfter(moving, jerk);
  }

  /** Along the arc, by a distance in m that is not negative. */
  private void move(double distance) {
    double way = direction * distance;
    double before = heading;
    heading += way * curvature;
    if (curvature == 0.0) {
      along += way * StrictMath.cos(heading);
      across += way * StrictMath.sin(heading);
    } else {
      along += (StrictMath.sin(heading) - StrictMath.sin(before)) / curvature;
      across += (StrictMath.cos(before) - StrictMath.cos(heading)) / curvature;
    }
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
