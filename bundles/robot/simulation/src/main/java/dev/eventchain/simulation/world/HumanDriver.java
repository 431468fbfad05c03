package dev.eventchain.simulation.world;

import java.util.List;

/**
 * The ego's driver, who follows a script of speeds and lane offsets while the software does not
 * drive. Without a script, the speed is kept, and the wheels are straight on a straight road.
 *
 * @param motion the desired speed and position in the lane
 * @param scripted true if the driver is said to steer, and not only follows a bend as long as the
 *     software does not steer
 */
public record HumanDriver(Motion motion, boolean scripted) {

  /** Creates a driver whose maneuvers all begin at known times. */
  public HumanDriver(SpeedProfile speed, LateralProfile line, boolean scripted) {
    this(Motion.of(speed, line), scripted);
  }

  /** Time constant of the speed control, in s. */
  private static final double SPEED_TIME = 0.3;

  /** Time constant of the control of the lane offset, in s. */
  private static final double LINE_TIME = 1.0;

  /** Time constant of the control of the heading, in s. */
  private static final double HEADING_TIME = 0.2;

  /** Minimum speed for steering, in m/s. */
  private static final double SLOWEST = 0.5;

  /** Returns this driver with maneuvers that begin by themselves, as {@link Actor#then}. */
  public HumanDriver then(double begun, List<Maneuver> maneuvers) {
    return new HumanDriver(motion.then(begun, maneuvers), scripted);
  }

  /** Returns this driver with the maneuvers that begin now. */
  HumanDriver continued(long now, Trace moment) {
    return motion.waits() ? new HumanDriver(motion.continued(now, moment), scripted) : this;
  }

  /**
   * Returns the desired acceleration, in m/s2: that of the script, and the correction of the speed.
   */
  double acceleration(double seconds, double driven) {
    double wanted = motion.speed().speed(seconds);
    double feedForward = motion.speed().acceleration(seconds);
    return wanted == driven && feedForward == 0.0
        ? 0.0
        : feedForward + (wanted - driven) / SPEED_TIME;
  }

  /** Returns whether the driver steers at all. */
  boolean steers(Road road) {
    return scripted || !road.isStraight();
  }

  /**
   * Returns the desired curvature, in 1/m, positive to the left.
   *
   * @param station of the ego's front bumper
   * @param heading of the ego relative to the road at its rear axle, in rad
   */
  double curvature(Road road, Road.Station station, double heading, double driven, double seconds) {
    if (driven < SLOWEST) {
      return 0.0;
    }
    double error = motion.line().offset(seconds) - station.across();
    double aside = motion.line().rate(seconds) + error / LINE_TIME;
    double wanted = StrictMath.asin(Math.max(-0.5, Math.min(0.5, aside / driven)));
    double bend = road.curvature(station.along());
    double follows = bend / (1.0 - bend * station.across());
    return follows + (wanted - heading) / (HEADING_TIME * driven);
  }
}
