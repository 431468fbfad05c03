package dev.eventchain.simulation.world;

import java.util.List;

/**
 * A road user or an object on the road or over it, other than the ego; moves by its script, whose
 * maneuvers begin at fixed times or by what happens. Its speed is that along the centre line of the
 * ego's lane, also in a bend. Immutable.
 */
public final class Actor {

  /** Maximum angle between a vehicle that changes its lane and the road, as a slope. */
  private static final double STEEPEST = 1.0 / 3.0;

  /** Upper bound of an actor's yaw rate, in rad/s. */
  private static final double TURNING = 1.0;

  /** Length, width, and the heights of its lower and its upper side above the road, in m. */
  public record Size(double length, double width, double bottom, double top) {}

  private final String name;
  private final ActorKind kind;
  private final Size size;
  private final double start;
  private final double heading;
  private final Motion motion;
  private final boolean turns;

  /**
   * Creates an actor.
   *
   * @param name its name for users
   * @param gap from the ego's front bumper to its nearest end at the start, in m; negative behind
   * @param heading from the direction of the road, in rad, to the left is positive
   */
  public Actor(
      String name,
      ActorKind kind,
      Size size,
      double gap,
      double heading,
      SpeedProfile speed,
      LateralProfile offset) {
    this(
        name,
        kind,
        size,
        gap + Body.extent(size.length(), size.width(), heading),
        heading,
        Motion.of(speed, offset),
        true);
  }

  private Actor(
      String name,
      ActorKind kind,
      Size size,
      double start,
      double heading,
      Motion motion,
      boolean turns) {
    this.name = name;
    this.kind = kind;
    this.size = size;
    this.start = start;
    this.heading = heading;
    this.motion = motion;
    this.turns = turns;
  }

  /** Returns this actor, but one that keeps its direction while it moves sideways. */
  public Actor withoutTurning() {
    return new Actor(name, kind, size, start, heading, motion, false);
  }

  /**
   * Returns this actor with maneuvers that begin by themselves.
   *
   * @param begun when the last maneuver of a known time begins, in s
   */
  public Actor then(double begun, List<Maneuver> maneuvers) {
    return with(motion.then(begun, maneuvers));
  }

  private Actor with(Motion other) {
    return new Actor(name, kind, size, start, heading, other, turns);
  }

  /** Returns this actor with the maneuvers that begin now. */
  Actor continued(long now, Trace moment) {
    return waits() ? with(motion.continued(now, moment)) : this;
  }

  /** Returns whether a maneuver has not begun. */
  boolean waits() {
    return motion.waits();
  }

  /** Returns the maneuvers that have not begun. */
  List<Maneuver> waiting() {
    return motion.waiting();
  }

  /** Returns a passenger car that keeps its speed and its lane. */
  public static Actor passengerCar(double gap, double speed, double lateralOffset) {
    return new Actor(
        "car",
        ActorKind.CAR,
        ActorKind.CAR.size(),
        gap,
        0.0,
        new SpeedProfile(speed, List.of()),
        new LateralProfile(lateralOffset, List.of()));
  }

  public String name() {
    return name;
  }

  public ActorKind kind() {
    return kind;
  }

  public Size size() {
    return size;
  }

  /**
   * Returns the position of its middle along the road, in m from the start of the ego's front
   * bumper.
   */
  public double along(double seconds) {
    return start + StrictMath.cos(heading) * motion.speed().way(seconds);
  }

  /** Returns the position of its middle left of the centre line of the ego's lane, in m. */
  public double across(double seconds) {
    double crossing = heading == 0.0 ? 0.0 : StrictMath.sin(heading) * motion.speed().way(seconds);
    return motion.line().offset(seconds) + crossing;
  }

  /**
   * Returns its direction relative to that of the road, in rad; that of a vehicle follows its
   * motion.
   */
  double heading(double seconds) {
    double rate = motion.line().rate(seconds);
    if (rate == 0.0 || !turns) {
      return heading;
    }
    double forwards = Math.max(motion.speed().speed(seconds), Math.abs(rate) / STEEPEST);
    double side = StrictMath.cos(heading) < 0.0 ? -1.0 : 1.0;
    return heading + side * StrictMath.atan(rate / forwards);
  }

  /**
   * Returns the position of its nearest end along the road, in m from the start of the ego's front
   * bumper.
   */
  public double rear(double seconds) {
    return along(seconds) - reach(seconds);
  }

  /** Returns the distance from its middle to its ends along the road, in m. */
  public double reach(double seconds) {
    return Body.extent(size.length(), size.width(), heading(seconds));
  }

  /** Returns the distance from its middle to its sides across the road, in m. */
  double breadth(double seconds) {
    return Body.extent(size.length(), size.width(), heading(seconds) - Math.PI / 2);
  }

  /** Returns its speed along the road, in m/s; negative if it is oncoming. */
  public double speedAlong(double seconds) {
    return StrictMath.cos(heading) * motion.speed().speed(seconds);
  }

  /** Returns its speed across the road, in m/s; positive to the left. */
  public double speedAcross(double seconds) {
    return motion.line().rate(seconds) + StrictMath.sin(heading) * motion.speed().speed(seconds);
  }

  /** Returns its box after some seconds. */
  public Body body(Road road, double seconds) {
    Road.Place place = road.place(along(seconds), across(seconds));
    Road.Place turned = new Road.Place(place.x(), place.y(), place.heading() + heading(seconds));
    return new Body(
        turned, size.length(), size.width(), size.bottom(), size.top(), kind.intensity());
  }

  /** Returns whether it stands from a time on, in s. */
  public boolean restsFrom(double seconds) {
    return motion.restsFrom(seconds);
  }

  /** Returns an upper bound of the speed of any of its points, in m/s. */
  public double fastest() {
    double aside = motion.fastestAside();
    double turning = aside == 0.0 ? 0.0 : TURNING * (size.length() + size.width()) / 2;
    return motion.fastest() + aside + turning;
  }

  /**
   * Returns whether a vehicle would hit it: it neither hangs above its roof nor can be driven over.
   */
  public boolean obstructs(Shape vehicle) {
    return size.bottom() < vehicle.height() && size.top() > EgoVehicle.CLEARANCE;
  }
}
