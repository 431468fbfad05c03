package dev.eventchain.simulation.world;

/**
 * Mounting and errors of a vehicle's lidar.
 *
 * @param behindBumper from the front bumper back to the lidar, in m
 * @param aboveRoad from the road up to the lidar, in m
 * @param noise standard deviation of a measured range, in m
 * @param dropout fraction of the rays that return nothing although they hit something, 0 to 1
 * @param azimuthStep horizontal angle between its rays, in degrees
 */
public record LidarSettings(
    double behindBumper, double aboveRoad, double noise, double dropout, double azimuthStep) {

  /** Mounting that the AEB example's object detection assumes. */
  public static final LidarSettings USUAL = new LidarSettings(2.4, 2.4, 0.01, 0.0, 0.5);
}
