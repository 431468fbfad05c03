package dev.eventchain.openscenario.storyboard.world;

/** Limits of a vehicle: m/s and m/s2, all positive. */
public record Performance(double maxSpeed, double maxAcceleration, double maxDeceleration) {

  /** That of what has no limits, such as a pedestrian. */
  public static final Performance UNLIMITED =
      new Performance(Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);

  /** Returns a speed within the limit, forward or backward. */
  public double limited(double speed) {
    return Math.max(-maxSpeed, Math.min(maxSpeed, speed));
  }

  /** Returns the largest change of speed per second from one speed towards another one. */
  public double rate(double from, double to) {
    return Math.abs(to) >= Math.abs(from) ? maxAcceleration : maxDeceleration;
  }
}
