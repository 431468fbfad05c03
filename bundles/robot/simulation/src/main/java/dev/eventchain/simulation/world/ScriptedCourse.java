package dev.eventchain.simulation.world;

/**
 * The course of an actor that follows a script. Immutable.
 *
 * @param start position of its middle along the road at the start, in m
 * @param heading from the direction of the road, in rad, to the left is positive
 * @param turns false if it keeps its direction while it moves sideways
 */
record ScriptedCourse(double start, double heading, Motion motion, boolean turns)
    implements Course {

  /** Maximum angle between a vehicle that changes its lane and the road, as a slope. */
  private static final double STEEPEST = 1.0 / 3.0;

  /** Upper bound of an actor's yaw rate, in rad/s. */
  private static final double TURNING = 1.0;

  @Override
  public Road.Place place(Road road, double seconds) {
    Road.Place place = road.place(along(seconds), across(seconds));
    return new Road.Place(place.x(), place.y(), place.heading() + heading(seconds));
  }

  @Override
  public Road.Station station(double seconds) {
    return new Road.Station(along(seconds), across(seconds));
  }

  private double along(double seconds) {
    return start + StrictMath.cos(heading) * motion.speed().way(seconds);
  }

  private double across(double seconds) {
    double crossing = heading == 0.0 ? 0.0 : StrictMath.sin(heading) * motion.speed().way(seconds);
    return motion.line().offset(seconds) + crossing;
  }

  /** Returns the direction of the front, which for a vehicle follows its motion. */
  @Override
  public double heading(double seconds) {
    double rate = motion.line().rate(seconds);
    if (rate == 0.0 || !turns) {
      return heading;
    }
    double forwards = Math.max(motion.speed().speed(seconds), Math.abs(rate) / STEEPEST);
    double side = StrictMath.cos(heading) < 0.0 ? -1.0 : 1.0;
    return heading + side * StrictMath.atan(rate / forwards);
  }

  @Override
  public double speedAlong(double seconds) {
    return StrictMath.cos(heading) * motion.speed().speed(seconds);
  }

  @Override
  public double speedAcross(double seconds) {
    return motion.line().rate(seconds) + StrictMath.sin(heading) * motion.speed().speed(seconds);
  }

  @Override
  public boolean restsFrom(double seconds) {
    return motion.restsFrom(seconds);
  }

  @Override
  public double fastest(double reach) {
    double aside = motion.fastestAside();
    return motion.fastest() + aside + (aside == 0.0 ? 0.0 : TURNING * reach);
  }

  @Override
  public boolean exists(double seconds) {
    return true;
  }
}
