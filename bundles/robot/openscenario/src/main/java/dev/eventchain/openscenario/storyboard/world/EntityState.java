package dev.eventchain.openscenario.storyboard.world;

import java.util.Optional;

/**
 * An entity at a moment.
 *
 * @param pose its reference point, for a vehicle the middle of the rear axle on the ground
 * @param speed in m/s along its heading; negative backward
 * @param acceleration in m/s2 along its heading
 * @param vx velocity of the reference point in the world, in m/s
 * @param vy likewise
 * @param yawRate in rad/s, positive to the left
 * @param road where it is on the roads; empty off the road
 * @param visibility who sees it
 * @param exists whether it is in the world; what is not has no meaningful position
 */
public record EntityState(
    Pose pose,
    double speed,
    double acceleration,
    double vx,
    double vy,
    double yawRate,
    Optional<LanePoint> road,
    Visibility visibility,
    boolean exists) {

  /** That of an entity which is not in the world. */
  public static final EntityState ABSENT =
      new EntityState(Pose.flat(0, 0, 0), 0, 0, 0, 0, 0, Optional.empty(), Visibility.ALL, false);

  /** Returns the state of an entity that moves along its heading. */
  public static EntityState along(Pose pose, double speed, Optional<LanePoint> road) {
    return new EntityState(
        pose,
        speed,
        0,
        speed * StrictMath.cos(pose.heading()),
        speed * StrictMath.sin(pose.heading()),
        0,
        road,
        Visibility.ALL,
        true);
  }

  /** Returns the curvature of its way in 1/m, positive to the left; 0 while it stands. */
  public double curvature() {
    return Math.abs(speed) < 1e-9 ? 0 : yawRate / speed;
  }

  /** Returns the acceleration across its heading, in m/s2, positive to the left. */
  public double lateralAcceleration() {
    return speed * yawRate;
  }

  /** Returns the state with another speed, along its heading. */
  public EntityState withSpeed(double newSpeed) {
    return new EntityState(
        pose,
        newSpeed,
        0,
        newSpeed * StrictMath.cos(pose.heading()),
        newSpeed * StrictMath.sin(pose.heading()),
        0,
        road,
        visibility,
        exists);
  }

  public EntityState withVisibility(Visibility newVisibility) {
    return new EntityState(pose, speed, acceleration, vx, vy, yawRate, road, newVisibility, exists);
  }

  public EntityState withRoad(Optional<LanePoint> newRoad) {
    return new EntityState(pose, speed, acceleration, vx, vy, yawRate, newRoad, visibility, exists);
  }
}
