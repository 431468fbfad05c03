package dev.eventchain.simulation.world;

import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Position and motion of the ego. Along its path it is a point mass whose deceleration follows a
 * demand with a limited slope; an acceleration is a negative one. Between two changes of the demand
 * the jerk is piecewise constant, so each piece is integrated exactly and the result does not
 * depend on a step size; only the drag is held for at most 10 ms. The path is that of a kinematic
 * bicycle (Rajamani, Vehicle Dynamics and Control, 2.2): the rear axle follows an arc without slip,
 * whose curvature is the tangent of the steering angle divided by the wheelbase.
 *
 * <p>A vehicle that keeps a commanded speed by itself changes it by its maximal acceleration or
 * deceleration until it has it, and turns by the commanded rate, as tight as its wheels allow. One
 * that turns on the spot has the commanded rate whatever its speed, up to its maximum: its rear
 * axle moves along the heading, without slip.
 *
 * <p>Instead, a vehicle may change its speed in steps, at the start of each: driver models that are
 * published with this step come to other results on a vehicle that changes it continuously.
 */
public final class EgoMotion {

  private final double slope;
  private final double speedStep;
  private final double maximalDeceleration;
  private final double coastingDeceleration;
  private final double maximalAcceleration;
  private final Chassis chassis;
  private final Shape shape;
  private final Axle axle;

  private double curvature;

  /** Yaw rate of a vehicle that turns on the spot, in rad/s. */
  private double spin;

  private int direction = 1;
  private VehicleCommand command = VehicleCommand.drive(0.0);
  private double speed;
  private double deceleration;

  /** True while the driver controls the pedals, until the software demands something. */
  private boolean held = true;

  /** True while the driver controls the wheel, until the software steers. */
  private boolean steered = true;

  /** The driver's demand of deceleration, in m/s2. */
  private double driven;

  /** The motion that the vehicle keeps by itself. */
  private Optional<VehicleCommand.Motor> motor = Optional.empty();

  public EgoMotion(EgoVehicle vehicle) {
    this.maximalDeceleration = vehicle.maximalDeceleration();
    this.coastingDeceleration = vehicle.coastingDeceleration();
    this.maximalAcceleration = vehicle.maximalAcceleration();
    this.slope =
        vehicle.brakeBuildUp() > 0.0
            ? maximalDeceleration / vehicle.brakeBuildUp()
            : Double.POSITIVE_INFINITY;
    this.speedStep = vehicle.speedStep();
    this.speed = vehicle.speed();
    this.chassis = vehicle.chassis();
    this.shape = vehicle.shape();
    this.axle = Axle.start(vehicle.axleToBumper(), chassis.offset(), chassis.heading());
  }

  private EgoMotion(EgoMotion other) {
    this.slope = other.slope;
    this.speedStep = other.speedStep;
    this.maximalDeceleration = other.maximalDeceleration;
    this.coastingDeceleration = other.coastingDeceleration;
    this.maximalAcceleration = other.maximalAcceleration;
    this.chassis = other.chassis;
    this.shape = other.shape;
    this.axle = other.axle.copy();
    this.curvature = other.curvature;
    this.spin = other.spin;
    this.direction = other.direction;
    this.speed = other.speed;
    this.deceleration = other.deceleration;
    this.command = other.command;
    this.held = other.held;
    this.steered = other.steered;
    this.driven = other.driven;
    this.motor = other.motor;
  }

  /** Returns a copy, to try out a time step. */
  EgoMotion copy() {
    return new EgoMotion(this);
  }

  /** Returns the position of the middle of the front bumper, and its heading. */
  public Road.Place front() {
    return axle.front();
  }

  /** Returns the body. */
  public Body body() {
    return shape.body(front());
  }

  /** Returns the size of the body. */
  public Shape shape() {
    return shape;
  }

  /**
   * Returns an upper bound of the speed of any point of the body in a time step, in m/s.
   *
   * @param change by which the speed grows at most
   */
  double fastest(double change) {
    double ends = Math.max(axle.toBumper(), shape.length() - axle.toBumper());
    double farthest = ends + shape.width() / 2;
    return spins()
        ? speed + change + chassis.maximalYawRate() * farthest
        : (speed + change) * (1.0 + turning() * farthest);
  }

  /** Returns an upper bound of the curvature of its path in a time step, in 1/m. */
  private double turning() {
    return turnsItself() ? chassis.tightest() : speed > 0.0 ? Math.abs(curvature) : 0.0;
  }

  /** Returns whether it keeps a yaw rate by itself. */
  private boolean turnsItself() {
    return !steered && motor.filter(it -> it.yawRate().isPresent()).isPresent();
  }

  /** Returns whether its yaw rate does not depend on its speed. */
  private boolean spins() {
    return chassis.turnsOnTheSpot() && turnsItself();
  }

  /** Returns the yaw rate in rad/s, positive to the left. */
  double yawRate() {
    return spins() ? spin : velocity() * curvature;
  }

  /** Returns the yaw rate of a vehicle that turns on the spot, in rad/s; 0 for all others. */
  double spin() {
    return spins() ? spin : 0.0;
  }

  /** Returns the distance from the rear axle to the front bumper, in m. */
  double axleToBumper() {
    return axle.toBumper();
  }

  /** Returns the speed in m/s, never negative. */
  double speed() {
    return speed;
  }

  /** Returns the velocity along its own axis, in m/s; negative backwards. */
  public double velocity() {
    return direction * speed;
  }

  /**
   * Returns the deceleration of the velocity in m/s2; zero at standstill, negative while it speeds
   * up.
   */
  double deceleration() {
    return speed > 0.0 ? direction * deceleration : 0.0;
  }

  /** Returns whether the driver controls the pedals. */
  boolean held() {
    return held;
  }

  /** Returns whether the driver controls the wheel. */
  boolean steered() {
    return steered;
  }

  /** Sets the driver's demand on the pedals, as an acceleration in m/s2. */
  void drive(double acceleration) {
    driven = Math.max(-maximalAcceleration, Math.min(maximalDeceleration, -acceleration));
  }

  /** Sets the acceleration, in m/s2, whatever the vehicle can do, until the software drives. */
  void driveExactly(double acceleration) {
    driven = 0.0 - acceleration;
    deceleration = driven;
  }

  /** Sets the driver's demand on the wheel, as a curvature in 1/m. */
  void steer(double wanted) {
    double tightest = chassis.curvature(-1.0);
    curvature = Math.max(-tightest, Math.min(tightest, wanted));
  }

  /**
   * Puts a command into effect. The driver controls the pedals until the software first demands
   * throttle, brake, hand brake or another gear, and then releases them: without any, the vehicle
   * coasts. Software that steers has the wheel from its first command on, also if that is 0; only a
   * driver who is said to steer keeps it until the command first differs from 0. Braking overrides
   * driving; the throttle adds to coasting in proportion, up to the maximal acceleration. Another
   * direction is engaged at standstill.
   *
   * @param driverSteers true if the driver is said to steer
   */
  void follow(VehicleCommand newCommand, boolean driverSteers) {
    command = newCommand;
    steered &= !command.turns() && (driverSteers || !command.steers());
    if (!steered) {
      curvature = chassis.curvature(command.limitedSteering());
    }
    if (command.motor().filter(it -> !it.isRenewed()).isEmpty()) {
      motor = command.motor();
    }
    held &=
        motor.isEmpty()
            && command.limitedBrake() == 0.0
            && command.limitedThrottle() == 0.0
            && !command.handBrake()
            && command.gear() == 1;
  }

  /** Lets a vehicle that keeps a speed by itself stop, and no longer turn. */
  void halt() {
    motor =
        motor.map(
            it ->
                new VehicleCommand.Motor(
                    0.0, it.yawRate().isPresent() ? OptionalDouble.of(0.0) : it.yawRate(), false));
  }

  /** Lets the driver release the pedals or the wheel, which then is straight. */
  void release(boolean pedals, boolean wheel) {
    held &= !pedals;
    if (wheel && steered) {
      steered = false;
      curvature = chassis.curvature(0.0);
    }
  }

  /** Returns the deceleration that the command demands, in m/s2. */
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

  /** Begins a step of a speed that changes in steps, with the demand of this moment. */
  void step() {
    if (motor.isPresent()) {
      return; // it changes its speed continuously
    }
    engage();
    double change = slope * speedStep;
    double demand = demand();
    deceleration = Math.max(deceleration - change, Math.min(deceleration + change, demand));
    speed = Math.max(0.0, speed - deceleration * speedStep);
  }

  /** Engages the gear, which a vehicle does at standstill. */
  private void engage() {
    if (speed == 0.0 && command.gear() != 0) {
      direction = command.gear();
    }
  }

  /** Advances the motion by some seconds. */
  void advance(double seconds) {
    if (motor.isPresent()) {
      keep(motor.get(), seconds);
      return;
    }
    if (speedStep > 0.0) {
      move(speed * seconds);
      return;
    }
    engage();
    double left = seconds;
    double demand = demand();
    while (left > 0.0) {
      // In a piece the deceleration keeps its sign, so that the speed is monotonic.
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

  /** Advances a vehicle that keeps a speed by itself, in pieces of constant acceleration. */
  private void keep(VehicleCommand.Motor wanted, double seconds) {
    double left = seconds;
    while (left > 0.0) {
      if (speed == 0.0 && wanted.speed() != 0.0) {
        direction = wanted.speed() < 0.0 ? -1 : 1;
      }
      double target = Math.max(0.0, direction * wanted.speed());
      double most = target > speed ? maximalAcceleration : maximalDeceleration;
      double needed = most > 0.0 ? Math.abs(target - speed) / most : Double.POSITIVE_INFINITY;
      deceleration = target == speed ? 0.0 : target > speed ? -most : most;
      double piece = target == speed ? left : Math.min(needed, left);
      double after = piece == needed ? target : speed - deceleration * piece;
      keep(wanted.yawRate(), after, piece);
      speed = after;
      left -= piece;
    }
    if (speed == Math.max(0.0, direction * wanted.speed())) {
      deceleration = 0.0;
    }
  }

  /** Moves by a piece of constant acceleration, at whose end it has another speed. */
  private void keep(OptionalDouble yawRate, double after, double seconds) {
    double distance = (speed + after) / 2.0 * seconds;
    if (spins()) {
      double most = chassis.maximalYawRate();
      spin = Math.max(-most, Math.min(most, yawRate.getAsDouble()));
      axle.swing(spin, direction * speed, direction * after, seconds);
    } else {
      if (turnsItself()) {
        turn(yawRate.getAsDouble() * seconds, direction * distance);
      }
      move(distance);
    }
  }

  /** Sets the curvature by which the heading turns by an angle on a way, if the wheels allow it. */
  private void turn(double angle, double way) {
    steer(way == 0.0 ? 0.0 : angle / way);
  }

  /** Integrates one piece with a constant change of the deceleration, in m/s3. */
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

  /** Moves along the arc, by a distance in m that is not negative. */
  private void move(double distance) {
    axle.move(direction * distance, curvature);
  }

  private double speedAfter(double seconds, double jerk) {
    return Math.max(0.0, speed - deceleration * seconds - jerk * seconds * seconds / 2.0);
  }

  /** Returns the part of a piece until standstill, by bisection, since the speed does not grow. */
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
