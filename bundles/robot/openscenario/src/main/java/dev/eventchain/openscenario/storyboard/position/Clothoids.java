package dev.eventchain.openscenario.storyboard.position;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.world.Pose;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * A path of clothoids: parts with linear curvature. The speed is constant along each part that has
 * times at both ends.
 */
final class Clothoids implements Path {

  /**
   * A part.
   *
   * @param start its first point, with its direction
   * @param begin the way to it, in m
   * @param curvature at its begin, in 1/m
   * @param slope the change of the curvature per m
   * @param time at its begin; NaN for none
   */
  private record Part(
      Pose start, double begin, double length, double curvature, double slope, double time) {

    /** Returns the pose after a way; Simpson's rule over pieces in which it hardly turns. */
    Pose pose(double way) {
      int pieces = 8 + 2 * (int) Math.ceil(24 * Math.abs(heading(way) - heading(0)) + way / 10);
      double x = 0;
      double y = 0;
      for (int i = 0; i <= pieces; i++) {
        double weight = i == 0 || i == pieces ? 1 : i % 2 == 1 ? 4 : 2;
        double heading = heading(way * i / pieces);
        x += weight * StrictMath.cos(heading);
        y += weight * StrictMath.sin(heading);
      }
      double factor = way / pieces / 3;
      return new Pose(
              start.x() + factor * x,
              start.y() + factor * y,
              start.z(),
              0,
              start.pitch(),
              start.roll())
          .withHeading(heading(way));
    }

    double heading(double way) {
      return start.heading() + way * (curvature + slope * way / 2);
    }
  }

  private final List<Part> parts;
  private final double end;

  private Clothoids(List<Part> parts, double end) {
    this.parts = parts;
    this.end = end;
  }

  static Path single(ScenarioElement shape, Pose start) {
    double slope = shape.number("curvaturePrime", shape.number("curvatureDot", 0));
    double time = shape.number("startTime", Double.NaN);
    Part part = new Part(start, 0, shape.number("length"), shape.number("curvature"), slope, time);
    double end = shape.number("stopTime", Double.NaN);
    if (end < time) {
      throw Trajectory.wrong(shape, "The trajectory ends before it begins.");
    }
    return new Clothoids(List.of(part), Double.isNaN(time) ? Double.NaN : end);
  }

  static Path spline(ScenarioElement shape, Scene scene) {
    List<Part> parts = new ArrayList<>();
    double begin = 0;
    Optional<Pose> start = Optional.empty();
    for (ScenarioElement each : shape.children("ClothoidSplineSegment")) {
      Optional<Pose> own =
          each.child("PositionStart").map(at -> Positions.read(at).in(scene).pose());
      Pose before = start.orElse(null);
      if (own.isEmpty() && before == null) {
        throw Trajectory.wrong(each, "The first segment of the trajectory has no start.");
      }
      Pose from = own.orElse(before);
      double length = each.number("length");
      double first = each.number("curvatureStart");
      Part part =
          new Part(
              from.withHeading(from.heading() + each.number("hOffset", 0)),
              begin,
              length,
              first,
              (each.number("curvatureEnd") - first) / length,
              each.number("timeStart", Double.NaN));
      parts.add(part);
      begin += length;
      start = Optional.of(part.pose(length));
    }
    boolean timed = parts.stream().noneMatch(each -> Double.isNaN(each.time()));
    return new Clothoids(parts, timed ? shape.number("timeEnd", Double.NaN) : Double.NaN);
  }

  @Override
  public double length() {
    Part last = parts.get(parts.size() - 1);
    return last.begin() + last.length();
  }

  private Part at(double way) {
    Part found = parts.get(0);
    for (Part each : parts) {
      if (each.begin() <= way) {
        found = each;
      }
    }
    return found;
  }

  @Override
  public Pose pose(double way) {
    Part part = at(way);
    return part.pose(way - part.begin());
  }

  @Override
  public boolean isTimed() {
    return !Double.isNaN(end);
  }

  @Override
  public double end() {
    return end;
  }

  private int index(double time) {
    int index = 0;
    for (int i = 1; i < parts.size(); i++) {
      if (parts.get(i).time() <= time) {
        index = i;
      }
    }
    return index;
  }

  private double endOf(int index) {
    return index + 1 < parts.size() ? parts.get(index + 1).time() : end;
  }

  @Override
  public double way(double time) {
    Part part = parts.get(index(time));
    if (time <= part.time()) {
      return part.begin();
    }
    double duration = endOf(index(time)) - part.time();
    double share = duration > 0 ? Math.min(1, (time - part.time()) / duration) : 1;
    return part.begin() + part.length() * share;
  }

  @Override
  public double speed(double time) {
    Part part = parts.get(index(time));
    double duration = endOf(index(time)) - part.time();
    return time < part.time() || !(duration > 0) ? 0 : part.length() / duration;
  }

  @Override
  public OptionalDouble nearest(Pose place) {
    List<Pose> points = new ArrayList<>();
    int count = 2 + (int) Math.min(2000, length());
    for (int i = 0; i <= count; i++) {
      points.add(pose(length() * i / count));
    }
    Path sampled = new Polyline(points, new double[0]);
    OptionalDouble way = sampled.nearest(place);
    return way.isPresent()
        ? OptionalDouble.of(way.getAsDouble() / sampled.length() * length())
        : way;
  }
}
