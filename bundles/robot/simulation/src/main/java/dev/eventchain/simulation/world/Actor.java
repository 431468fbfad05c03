package dev.eventchain.simulation.world;

import java.util.List;

/**
 * Somebody or something on the road or over it besides the ego; moves as its script says, whatever
 * the ego does. Along the road it moves with its speed along the centre line of the ego's lane,
 * also in a bend. Immutable.
 */
public final class Actor {

  /** The largest angle between a vehicle that changes its lane and the road, as a slope. */
  private static final double STEEPEST = 1.0 / 3.0;

  /** The fastest that an actor turns, in rad/s; for a bound only. */
  private static final double TURNING = 1.0;

  /** Length, width, and the heights of its lower and its upper side above the road, in m. */
  public record Size(double length, double width, double bottom, double top) {}

  private final String name;
  private final ActorKind kind;
  private final Size size;
  private final double start;
  private final double heading;
  private final SpeedProfile speed;
  private final LateralProfile offset;

  /**
   * An actor.
   *
   * @param name as people call it
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
    this.name = name;
    this.kind = kind;
    this.size = size;
    this.heading = heading;
    this.speed = speed;
    this.offset = offset;
    this.start = gap + Body.extent(size.length(), size.width(), heading);
  }

  /** A passenger car that keeps its speed and its lane. */
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

  ActorKind kind() {
    return kind;
  }

  public Size size() {
    return size;
  }

  /** Its middle along the road after some seconds, in m from the ego's front bumper's start. */
  public double along(double seconds) {
    return start + StrictMath.cos(heading) * speed.way(seconds);
  }

  /** Its middle left of the centre line of the ego's lane, in m. */
  public double across(double seconds) {
    double crossing = heading == 0.0 ? 0.0 : StrictMath.sin(heading) * speed.way(seconds);
    return offset.offset(seconds) + crossing;
  }

  /** Its direction from that of the road, in rad; a vehicle looks where it goes. */
  double heading(double seconds) {
    double rate = offset.rate(seconds);
    if (rate == 0.0) {
      return heading;
    }
    double forwards = Math.max(speed.speed(seconds), Math.abs(rate) / STEEPEST);
    double side = StrictMath.cos(heading) < 0.0 ? -1.0 : 1.0;
    return heading + side * StrictMath.atan(rate / forwards);
  }

  /** Its nearest end along the road, in m from where the ego's front bumper started. */
  public double rear(double seconds) {
    return along(seconds) - reach(seconds);
  }

  /** From its middle to its ends along the road, in m. */
  public double reach(double seconds) {
    return Body.extent(size.length(), size.width(), heading(seconds));
  }

  /** From its middle to its sides across the road, in m. */
  double breadth(double seconds) {
    return Body.extent(size.length(), size.width(), heading(seconds) - Math.PI / 2);
  }

  /** Along the road, in m/s; negative if it comes. */
  public double speedAlong(double seconds) {
    return StrictMath.cos(heading) * speed.speed(seconds);
  }

  /** Across the road, in m/s; positive to the left. */
  public double speedAcross(double seconds) {
    return offset.rate(seconds) + StrictMath.sin(heading) * speed.speed(seconds);
  }

  /** Change of its speed along the road, in m/s2. */
  double accelerationAlong(double seconds) {
    return StrictMath.cos(heading) * speed.acceleration(seconds);
  }

  /** Its box after some seconds. */
  public Body body(Road road, double seconds) {
    Road.Place place = road.place(along(seconds), across(seconds));
    Road.Place turned = new Road.Place(place.x(), place.y(), place.heading() + heading(seconds));
    return new Body(
        turned, size.length(), size.width(), size.bottom(), size.top(), kind.intensity());
  }

  /** No point of it ever moves faster, in m/s. */
  double fastest() {
    double turning = offset.constant() ? 0.0 : TURNING * (size.length() + size.width()) / 2;
    return speed.fastest() + offset.fastest() + turning;
  }

  /** Whether a vehicle would hit it: it neither hangs above the roof nor can be driven over. */
  public boolean obstructs() {
    return size.bottom() < EgoVehicle.HEIGHT && size.top() > EgoVehicle.CLEARANCE;
  }
}
