package dev.eventchain.simulation.world;

/**
 * How the lidar of a vehicle is mounted, and what it gets wrong.
 *
 * @param behindBumper from the front bumper back to the lidar, in m
 * @param aboveRoad from the road up to the lidar, in m
 * @param noise standard deviation of a measured range, in m
 * @param dropout part of the rays that return nothing although something is there, 0 to 1
 * @param azimuthStep from one direction of its rings to the next, in degrees
 */
public record LidarSettings(
    double behindBumper, double aboveRoad, double noise, double dropout, double azimuthStep) {

  /** The mounting that the AEB example's object detection knows. */
  public static final LidarSettings USUAL = new LidarSettings(2.4, 2.4, 0.01, 0.0, 0.5);
}
