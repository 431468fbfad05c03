package dev.eventchain.simulation.sensor;

import java.util.Arrays;

/**
 * Directions of a lidar's rays in its own frame (x forward, y left, z up), ring by ring and in each
 * ring from right to left. StrictMath makes the points the same on every machine.
 */
final class LidarRays {

  /** Elevations of the rings, in degrees: those of a Velodyne VLP-32C (its data sheet). */
  private static final double[] ELEVATIONS = {
    15.0, 10.333, 7.0, 4.667, 3.333, 2.333, 1.667, 1.333, 1.0, 0.667, 0.333, 0.0, -0.333, -0.667,
    -1.0, -1.333, -1.667, -2.0, -2.333, -2.667, -3.0, -3.333, -3.667, -4.0, -4.667, -5.333, -6.148,
    -7.254, -8.843, -11.31, -15.639, -25.0
  };

  private static final double[] COSINES =
      Arrays.stream(ELEVATIONS).map(StrictMath::toRadians).map(StrictMath::cos).toArray();
  private static final double[] SINES =
      Arrays.stream(ELEVATIONS).map(StrictMath::toRadians).map(StrictMath::sin).toArray();

  /** Half of the horizontal field of view, in degrees. */
  private static final double HALF_VIEW = 60.0;

  private final double step;
  private final int azimuths;
  private final double[] x;
  private final double[] y;
  private final double[] z;

  private LidarRays(double step) {
    this.step = step;
    this.azimuths = (int) Math.floor(2 * HALF_VIEW / step) + 1;
    this.x = new double[count()];
    this.y = new double[count()];
    this.z = new double[count()];
    for (int index = 0; index < azimuths; index++) {
      double forward = StrictMath.cos(azimuth(index));
      double left = StrictMath.sin(azimuth(index));
      for (int ring = 0; ring < ELEVATIONS.length; ring++) {
        int ray = ring * azimuths + index;
        x[ray] = COSINES[ring] * forward;
        y[ray] = COSINES[ring] * left;
        z[ray] = SINES[ring];
      }
    }
  }

  /** Returns the directions for a horizontal step in degrees. */
  static LidarRays withStep(double degrees) {
    return new LidarRays(degrees);
  }

  /** Returns the number of rays. */
  int count() {
    return ELEVATIONS.length * azimuths;
  }

  /** Returns the number of rays of a ring. */
  int azimuths() {
    return azimuths;
  }

  double x(int ray) {
    return x[ray];
  }

  double y(int ray) {
    return y[ray];
  }

  double z(int ray) {
    return z[ray];
  }

  /** Returns the direction of a ray of a ring, in rad to the left. */
  double azimuth(int index) {
    return StrictMath.toRadians(index * step - HALF_VIEW);
  }

  /**
   * Returns the last ray of a ring that is not left of a direction in rad; it may be outside the
   * field of view.
   */
  int azimuthIndex(double direction) {
    return (int) Math.floor((StrictMath.toDegrees(direction) + HALF_VIEW) / step);
  }
}
