package dev.eventchain.openscenario.storyboard.position;

import dev.eventchain.openscenario.storyboard.world.Angles;
import dev.eventchain.openscenario.storyboard.world.Pose;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;

/**
 * A path of straight lines, with times at none or all of its points. Along a line the speed is
 * constant.
 */
final class Polyline implements Path {

  /** Distance from a path up to which a place is on it, in m. */
  private static final double NEAR = 2;

  private final List<Pose> points;
  private final double[] ways;
  private final double[] times;
  private final boolean oriented;

  /**
   * Creates a path along which the heading is that of its lines.
   *
   * @param points at least two
   * @param times as many as points; empty for none
   */
  Polyline(List<Pose> points, double[] times) {
    this(points, times, false);
  }

  /**
   * Creates a path.
   *
   * @param oriented whether the heading goes evenly from that of a point to that of the next one
   */
  Polyline(List<Pose> points, double[] times, boolean oriented) {
    this.points = List.copyOf(points);
    this.times = times.clone();
    this.oriented = oriented;
    ways = new double[points.size()];
    for (int i = 1; i < ways.length; i++) {
      ways[i] = ways[i - 1] + points.get(i - 1).distance(points.get(i));
    }
  }

  @Override
  public double length() {
    return ways[ways.length - 1];
  }

  @Override
  public Pose pose(double way) {
    int i = segment(ways, way);
    Pose from = points.get(i);
    Pose to = points.get(i + 1);
    double length = ways[i + 1] - ways[i];
    double part = length > 0 ? (way - ways[i]) / length : 0;
    return new Pose(
            from.x() + part * (to.x() - from.x()),
            from.y() + part * (to.y() - from.y()),
            from.z() + part * (to.z() - from.z()),
            0,
            from.pitch() + part * (to.pitch() - from.pitch()),
            from.roll() + part * (to.roll() - from.roll()))
        .withHeading(oriented ? turned(from, to, part) : ofLine(i));
  }

  @Override
  public double direction(double way) {
    return ofLine(segment(ways, way));
  }

  private static double turned(Pose from, Pose to, double part) {
    return from.heading() + part * Angles.normalized(to.heading() - from.heading());
  }

  /** Returns the direction of a line; that of the one before it if it has no length. */
  private double ofLine(int line) {
    for (int i = line; i >= 0; i--) {
      Pose from = points.get(i);
      Pose to = points.get(i + 1);
      if (from.x() != to.x() || from.y() != to.y()) {
        return StrictMath.atan2(to.y() - from.y(), to.x() - from.x());
      }
    }
    return points.get(line).heading();
  }

  /** Returns the index of the part in which a value is; the first or last one outside. */
  private static int segment(double[] values, double value) {
    int found = Arrays.binarySearch(values, value);
    int index = found >= 0 ? found : -found - 2;
    while (index >= 0 && index < values.length - 1 && values[index + 1] == value) {
      index++;
    }
    return Math.max(0, Math.min(values.length - 2, index));
  }

  @Override
  public boolean isTimed() {
    return times.length > 0;
  }

  @Override
  public double end() {
    return times[times.length - 1];
  }

  @Override
  public double way(double time) {
    if (time <= times[0]) {
      return 0;
    }
    if (time >= end()) {
      return length();
    }
    int i = segment(times, time);
    return ways[i] + (ways[i + 1] - ways[i]) * (time - times[i]) / (times[i + 1] - times[i]);
  }

  @Override
  public double speed(double time) {
    if (time < times[0]) {
      return 0;
    }
    int i = segment(times, time);
    double duration = times[i + 1] - times[i];
    return duration > 0 ? (ways[i + 1] - ways[i]) / duration : 0;
  }

  @Override
  public OptionalDouble nearest(Pose place) {
    double least = NEAR;
    OptionalDouble way = OptionalDouble.empty();
    for (int i = 0; i < points.size() - 1; i++) {
      Pose line = points.get(i).withHeading(ofLine(i));
      double along = Math.max(0, Math.min(ways[i + 1] - ways[i], line.ahead(place)));
      double off = StrictMath.hypot(line.ahead(place) - along, line.left(place));
      if (off < least) {
        least = off;
        way = OptionalDouble.of(ways[i] + along);
      }
    }
    return way;
  }
}
