package dev.eventchain.simulation.stage;

import dev.eventchain.openscenario.storyboard.world.EntityState;
import dev.eventchain.simulation.world.Director;
import dev.eventchain.simulation.world.Road;

/**
 * Steers the ego along the way that the storyboard wants, as long as the software does not steer.
 * Until the software has the pedals, the storyboard says where the rear axle has to be. From then
 * on the ego is elsewhere on its way: it follows the same line, or, where it follows its lane, only
 * its place across the road is wanted.
 */
final class ScenarioDriver {

  /** Time constants of the control of the place across the road and of the heading, in s. */
  private static final double LINE_TIME = 1.0;

  private static final double HEADING_TIME = 0.2;

  /** Minimum speed for steering, in m/s. */
  private static final double SLOWEST = 0.5;

  /** The largest part of the speed that goes across the road. */
  private static final double STEEPEST = 0.5;

  /** Angle to the road from which on the ego leaves it, and follows the lane that it is on. */
  private static final double LEAVES = Math.PI / 4;

  private final Frame frame;
  private final Road road;
  private final double axleToBumper;
  private double across;

  /**
   * Creates a driver.
   *
   * @param axleToBumper from the reference point to the front bumper, in m
   */
  ScenarioDriver(Frame frame, Road road, double axleToBumper) {
    this.frame = frame;
    this.road = road;
    this.axleToBumper = axleToBumper;
  }

  /**
   * Returns the curvature to drive until the next moment on a line, in 1/m.
   *
   * @param seen the ego now, wherever it is on the line
   * @param next the place on the line to go to
   * @param later one after it
   */
  double curvature(Director.Ego seen, EntityState next, EntityState later) {
    Road.Place line = frame.toWorld(next.pose());
    Road.Place beyond = frame.toWorld(later.pose());
    double turned = StrictMath.IEEEremainder(beyond.heading() - line.heading(), 2.0 * Math.PI);
    double way = StrictMath.hypot(beyond.x() - line.x(), beyond.y() - line.y());
    across = station(line).across();
    return seen.velocity() < SLOWEST || way == 0.0
        ? 0.0
        : towards(line, seen.front().ahead(-axleToBumper), turned / way, seen.velocity());
  }

  /**
   * Returns the curvature to drive until the next moment in a lane, or to any place before the
   * software has the pedals, in 1/m.
   *
   * @param seen the ego now
   * @param now what the storyboard knows of the ego now
   * @param next what it wants of it at the next moment
   */
  double curvatureOfLane(Director.Ego seen, EntityState now, EntityState next) {
    Road.Place axle = seen.front().ahead(-axleToBumper);
    Road.Place known = frame.toWorld(now.pose());
    Road.Place wanted = frame.toWorld(next.pose());
    Road.Station from = road.station(known.x(), known.y(), near(known));
    Road.Station to = road.station(wanted.x(), wanted.y(), near(known));
    double speed = seen.velocity();
    double steering =
        seen.pedals() && isAlongTheRoad(axle)
            ? alongTheRoad(axle, speed)
            : towards(known, axle, next.curvature(), speed);
    across = (seen.pedals() ? across : from.across()) + to.across() - from.across();
    return speed < SLOWEST ? 0.0 : steering;
  }

  private double near(Road.Place place) {
    return road.station(place.x(), place.y(), Double.NaN).along();
  }

  private Road.Station station(Road.Place place) {
    return road.station(place.x(), place.y(), near(place));
  }

  private boolean isAlongTheRoad(Road.Place axle) {
    double turned = axle.heading() - road.heading(near(axle));
    return Math.abs(StrictMath.IEEEremainder(turned, 2.0 * Math.PI)) < LEAVES;
  }

  private double alongTheRoad(Road.Place axle, double speed) {
    Road.Station station = station(axle);
    double bend = road.curvature(station.along());
    Road.Place line = road.place(station.along(), across);
    return towards(line, axle, bend / (1.0 - bend * station.across()), speed);
  }

  /** Returns the curvature that leads back to a line through a place, of some curvature. */
  private static double towards(Road.Place line, Road.Place axle, double curvature, double speed) {
    double cos = StrictMath.cos(line.heading());
    double sin = StrictMath.sin(line.heading());
    double left = (axle.y() - line.y()) * cos - (axle.x() - line.x()) * sin;
    double turned = StrictMath.IEEEremainder(axle.heading() - line.heading(), 2.0 * Math.PI);
    double slope = Math.max(-STEEPEST, Math.min(STEEPEST, -left / LINE_TIME / speed));
    return curvature + (StrictMath.asin(slope) - turned) / (HEADING_TIME * speed);
  }
}
