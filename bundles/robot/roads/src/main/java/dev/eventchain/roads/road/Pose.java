package dev.eventchain.roads.road;

/**
 * A place and a direction in the inertial frame, with the angles of ISO 8855.
 *
 * @param x in m
 * @param y in m
 * @param z in m
 * @param heading in rad, counterclockwise from x
 * @param pitch in rad, positive with the nose down
 * @param roll in rad, positive with the left side up
 */
public record Pose(double x, double y, double z, double heading, double pitch, double roll) {

  /** Returns the pose with the front where the back was. */
  public Pose turned() {
    return new Pose(x, y, z, heading + Math.PI, -pitch, -roll);
  }
}
