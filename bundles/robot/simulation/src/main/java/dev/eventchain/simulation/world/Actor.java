package dev.eventchain.simulation.world;

import dev.eventchain.roads.ground.Rectangle;
import java.util.List;
import java.util.Optional;

/**
 * A road user or an object on the road or over it, other than the ego; moves by its script, whose
 * maneuvers begin at fixed times or by what happens, or along a track. The speed of a script is
 * that along the centre line of the ego's lane, also in a bend. Immutable, but for a track that
 * grows.
 */
public final class Actor {

  /** Length, width, and the heights of its lower and its upper side above the road, in m. */
  public record Size(double length, double width, double bottom, double top) {

    /** Returns how far it reaches from its middle in a direction relative to its own, in m. */
    double extent(double direction) {
      return new Rectangle(0, 0, 0, length, width).extent(direction);
    }
  }

  private final String name;
  private final ActorKind kind;
  private final Size size;
  private final Course course;

  /**
   * Creates an actor.
   *
   * @param name its name for users
   * @param gap from the ego's front bumper to the end of it that comes first along the road, at the
   *     start, in m; negative behind
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
        new ScriptedCourse(gap + size.extent(heading), heading, Motion.of(speed, offset), true));
  }

  /** Creates an actor that something else moves along a track. */
  public Actor(String name, ActorKind kind, Size size, Track track) {
    this(name, kind, size, (Course) track);
  }

  private Actor(String name, ActorKind kind, Size size, Course course) {
    this.name = name;
    this.kind = kind;
    this.size = size;
    this.course = course;
  }

  /** Returns this actor, but one that keeps its direction while it moves sideways. */
  public Actor withoutTurning() {
    return course instanceof ScriptedCourse script
        ? with(new ScriptedCourse(script.start(), script.heading(), script.motion(), false))
        : this;
  }

  /**
   * Returns this actor with maneuvers that begin by themselves.
   *
   * @param begun when the last maneuver of a known time begins, in s
   */
  public Actor then(double begun, List<Maneuver> maneuvers) {
    return script().map(motion -> with(motion.then(begun, maneuvers))).orElse(this);
  }

  private Actor with(Motion motion) {
    ScriptedCourse script = (ScriptedCourse) course;
    return with(new ScriptedCourse(script.start(), script.heading(), motion, script.turns()));
  }

  private Actor with(ScriptedCourse other) {
    return new Actor(name, kind, size, other);
  }

  /** Returns its script; empty if something else moves it. */
  public Optional<Motion> script() {
    return course instanceof ScriptedCourse scripted
        ? Optional.of(scripted.motion())
        : Optional.empty();
  }

  /** Returns this actor with the maneuvers that begin now. */
  Actor continued(long now, Trace moment) {
    return waits() ? with(script().get().continued(now, moment)) : this;
  }

  /** Returns whether a maneuver has not begun. */
  boolean waits() {
    return script().filter(Motion::waits).isPresent();
  }

  /** Returns the maneuvers that have not begun. */
  List<Maneuver> waiting() {
    return script().map(Motion::waiting).orElse(List.of());
  }

  /** Returns whether it is there at a time, in s. */
  public boolean exists(double seconds) {
    return course.exists(seconds);
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
    return course.station(seconds).along();
  }

  /** Returns the position of its middle left of the centre line of the ego's lane, in m. */
  public double across(double seconds) {
    return course.station(seconds).across();
  }

  /** Returns whether it turns while it moves sideways, as a vehicle does. */
  public boolean turns() {
    return course instanceof ScriptedCourse scripted && scripted.turns();
  }

  /** Returns its direction relative to that of the road while it does not move sideways, in rad. */
  public double direction() {
    return course instanceof ScriptedCourse scripted ? scripted.heading() : heading(0.0);
  }

  /**
   * Returns its direction relative to that of the road, in rad; that of a vehicle follows its
   * motion.
   */
  double heading(double seconds) {
    return course.heading(seconds);
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
    return size.extent(heading(seconds));
  }

  /** Returns the distance from its middle to its sides across the road, in m. */
  public double breadth(double seconds) {
    return size.extent(heading(seconds) - Math.PI / 2);
  }

  /** Returns its speed along the road, in m/s; negative if it is oncoming. */
  public double speedAlong(double seconds) {
    return course.speedAlong(seconds);
  }

  /** Returns its speed across the road, in m/s; positive to the left. */
  public double speedAcross(double seconds) {
    return course.speedAcross(seconds);
  }

  /** Returns its box after some seconds. */
  public Body body(Road road, double seconds) {
    return new Body(
        course.place(road, seconds),
        size.length(),
        size.width(),
        size.bottom(),
        size.top(),
        kind.intensity());
  }

  /** Returns whether it stands from a time on, in s. */
  public boolean restsFrom(double seconds) {
    return course.restsFrom(seconds);
  }

  /** Returns an upper bound of the speed of any of its points, in m/s. */
  public double fastest() {
    return course.fastest((size.length() + size.width()) / 2);
  }

  /**
   * Returns whether a vehicle would hit it: it neither hangs above its roof nor can be driven over.
   */
  public boolean obstructs(Shape vehicle) {
    return size.bottom() < vehicle.height() && size.top() > EgoVehicle.CLEARANCE;
  }
}
