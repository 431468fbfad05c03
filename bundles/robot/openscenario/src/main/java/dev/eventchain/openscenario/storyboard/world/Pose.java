package dev.eventchain.openscenario.storyboard.world;

/**
 * A position and orientation in the world: m and rad, x forward, y left, z up; the heading counts
 * from the x axis to the left.
 */
public record Pose(double x, double y, double z, double heading, double pitch, double roll) {

  /** A pose in the plane. */
  public static Pose flat(double x, double y, double heading) {
    return new Pose(x, y, 0, heading, 0, 0);
  }

  /** Returns the pose that is moved in its own plane: forward and to the left. */
  public Pose moved(double forward, double left) {
    double cos = StrictMath.cos(heading);
    double sin = StrictMath.sin(heading);
    return new Pose(
        x + cos * forward - sin * left, y + sin * forward + cos * left, z, heading, pitch, roll);
  }

  public Pose withHeading(double newHeading) {
    return new Pose(x, y, z, Angles.normalized(newHeading), pitch, roll);
  }

  /** Returns how far a point is ahead of this pose; negative behind it. */
  public double ahead(Pose other) {
    return StrictMath.cos(heading) * (other.x - x) + StrictMath.sin(heading) * (other.y - y);
  }

  /** Returns how far a point is to the left of this pose; negative to the right. */
  public double left(Pose other) {
    return -StrictMath.sin(heading) * (other.x - x) + StrictMath.cos(heading) * (other.y - y);
  }

  /** Returns the distance in space. */
  public double distance(Pose other) {
    return StrictMath.hypot(Math.hypot(other.x - x, other.y - y), other.z - z);
  }
}
