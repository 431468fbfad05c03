package dev.eventchain.simulation.sensor;

import dev.eventchain.messages.MessageValue;
import dev.eventchain.simulation.world.Body;
import dev.eventchain.simulation.world.Road;
import dev.eventchain.simulation.world.World;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;

/**
 * A scanner in one horizontal plane, which sends sensor_msgs/LaserScan: from right to left, the
 * distance to the nearest box, post or wall that the plane cuts, with noise; infinite without an
 * echo, and negatively infinite nearer than the shortest distance (REP 117).
 *
 * @param mounting where it is, and where it looks
 * @param range longest distance, in m
 * @param nearest shortest distance, in m
 * @param halfView half of the field of view, in rad
 * @param step between rays, in rad
 * @param height of the plane over the road, in m
 * @param noise standard deviation of distances, in m
 */
public record LaserScanner(
    Mounting mounting,
    double range,
    double nearest,
    double halfView,
    double step,
    double height,
    double noise) {

  /** The fields that a scan fills. */
  public static final List<String> FILLED =
      List.of(
          "angle_min",
          "angle_max",
          "angle_increment",
          "scan_time",
          "range_min",
          "range_max",
          "ranges");

  /** Rounding must not lose the ray at the left end of the view. */
  private static final double ROUNDING = 1e-9;

  /** Returns the number of rays. */
  public int rays() {
    int steps = (int) Math.floor(2 * halfView / step + ROUNDING);
    // In a full circle, the last ray would be the first one again.
    return steps * step > 2 * Math.PI - step / 2 ? steps : steps + 1;
  }

  /**
   * Sets the constant fields in the messages of scans.
   *
   * @param period from scan to scan, in s
   */
  public void describe(MessageValue message, double period) {
    message.set("angle_min", -halfView);
    message.set("angle_max", (rays() - 1) * step - halfView);
    message.set("angle_increment", step);
    message.set("scan_time", period);
    message.set("range_min", nearest);
    message.set("range_max", range);
  }

  /** Writes one scan into a message, except its header. All rays are of the same moment. */
  public void scan(World world, SplittableRandom random, MessageValue message) {
    Road.Place eye = mounting.place(world.ego().front(), world.ego().shape());
    double[] distances = new double[rays()];
    Arrays.fill(distances, Double.POSITIVE_INFINITY);
    double[] forward = new double[distances.length];
    double[] left = new double[distances.length];
    for (int ray = 0; ray < distances.length; ray++) {
      forward[ray] = StrictMath.cos(azimuth(ray));
      left[ray] = StrictMath.sin(azimuth(ray));
    }
    if (height <= RoadScene.WALL_HEIGHT) {
      seeWalls(world.road(), eye, distances);
    }
    for (Body body : RoadScene.around(world, eye, range).bodies()) {
      if (body.bottom() <= height && body.top() >= height) {
        see(body, eye, distances, forward, left);
      }
    }
    float[] ranges = new float[distances.length];
    for (int ray = 0; ray < distances.length; ray++) {
      ranges[ray] = (float) measured(distances[ray], random);
    }
    message.set("ranges", ranges);
  }

  private double measured(double distance, SplittableRandom random) {
    if (distance > range) {
      return Double.POSITIVE_INFINITY;
    }
    double noisy = noise > 0.0 ? distance + noise * random.nextGaussian() : distance;
    if (noisy < nearest) {
      return Double.NEGATIVE_INFINITY;
    }
    return noisy > range ? Double.POSITIVE_INFINITY : noisy;
  }

  /** Returns the direction of a ray, in rad to the left of the sensor's. */
  private double azimuth(int ray) {
    return ray * step - halfView;
  }

  private void seeWalls(Road road, Road.Place eye, double[] distances) {
    for (int ray = 0; ray < distances.length; ray++) {
      double direction = eye.heading() + azimuth(ray);
      double wall = road.wall(eye, StrictMath.cos(direction), StrictMath.sin(direction));
      distances[ray] = Math.min(distances[ray], wall);
    }
  }

  /** Shortens the rays that hit a box. */
  private void see(Body body, Road.Place eye, double[] distances, double[] forward, double[] left) {
    double dx = body.place().x() - eye.x();
    double dy = body.place().y() - eye.y();
    double cos = StrictMath.cos(eye.heading());
    double sin = StrictMath.sin(eye.heading());
    LidarBox box = new LidarBox(body, dx * cos + dy * sin, dy * cos - dx * sin, eye, height);
    LidarBox.Span vertical = box.between(0.0);
    for (int ray = 0; ray < distances.length; ray++) {
      double distance = box.distance(forward[ray], left[ray], vertical, distances[ray]);
      distances[ray] = Math.min(distances[ray], distance);
    }
  }
}
