package dev.eventchain.simulation.world;

/**
 * The ego's driver: keeps to a script of speeds and of places in the lane, as long as the software
 * does not drive. Without a script he holds the speed, and on a straight road the wheels straight.
 *
 * @param speed what he wants to drive
 * @param line where in the lane he wants to be
 * @param scripted whether he steers; in a bend he always does
 */
public record HumanDriver(SpeedProfile speed, LateralProfile line, boolean scripted) {

  /** How fast he corrects a wrong speed, in s. */
  private static final double SPEED_TIME = 0.3;

  /** How fast he corrects a wrong place in the lane, in s. */
  private static final double LINE_TIME = 1.0;

  /** How fast he corrects a wrong direction, in s. */
  private static final double HEADING_TIME = 0.2;

  /** Slowest speed at which he steers, in m/s. */
  private static final double SLOWEST = 0.5;

  /** The acceleration that he wants, in m/s2: that of his script, and what a wrong speed needs. */
  double acceleration(double seconds, double driven) {
    double wanted = speed.speed(seconds);
    double feedForward = speed.acceleration(seconds);
    return wanted == driven && feedForward == 0.0
        ? 0.0
        : feedForward + (wanted - driven) / SPEED_TIME;
  }

  /** Whether he turns the wheel at all. */
  boolean steers(Road road) {
    return scripted || road.curvature() != 0.0;
  }

  /**
   * The curvature that he steers, in 1/m, to the left is positive.
   *
   * @param station of the ego's front bumper
   * @param heading of the ego relative to the road at its rear axle, in rad
   */
  double curvature(Road road, Road.Station station, double heading, double driven, double seconds) {
    if (driven < SLOWEST) {
      return 0.0;
    }
    double error = line.offset(seconds) - station.across();
    double aside = line.rate(seconds) + error / LINE_TIME;
    double wanted = StrictMath.asin(Math.max(-0.5, Math.min(0.5, aside / driven)));
    double follows = road.curvature() / (1.0 - road.curvature() * station.across());
    return follows + (wanted - heading) / (HEADING_TIME * driven);
  }
}
