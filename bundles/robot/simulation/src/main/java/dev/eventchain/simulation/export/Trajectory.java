package dev.eventchain.simulation.export;

import dev.eventchain.simulation.world.Road;
import java.util.ArrayList;
import java.util.List;

/** Trajectories as lines from vertex to vertex on the map. */
final class Trajectory {

  /** Largest time between two vertices, in s. */
  private static final double LONGEST = 0.1;

  /**
   * Largest number of times that such a time is halved, where a straight line is not near enough.
   */
  private static final int HALVES = 4;

  /** Distance and angle within which a straight line is near enough, in m and rad. */
  private static final double NEAR = 0.005;

  private Trajectory() {}

  /** Returns the action that leads through the places of a time, at their times. */
  static Markup timed(Mover mover, String name, Timeline.Span span) {
    List<Markup> vertices = new ArrayList<>();
    for (double seconds : times(mover, span)) {
      Road.Place place = mover.place().apply(seconds);
      vertices.add(vertex(place).with("time", seconds - span.from()));
    }
    Markup timing =
        new Markup("Timing")
            .with("domainAbsoluteRelative", "relative")
            .with("scale", 1.0)
            .with("offset", 0.0);
    return action(name, vertices, timing);
  }

  private static List<Double> times(Mover mover, Timeline.Span span) {
    double whole = span.to() - span.from();
    int steps = (int) Math.max(1, Math.ceil(whole / LONGEST - 1e-9));
    List<Double> times = new ArrayList<>(List.of(span.from()));
    for (int i = 0; i < steps; i++) {
      double begin = span.from() + whole * i / steps;
      halve(mover, begin, span.from() + whole * (i + 1) / steps, HALVES, times);
    }
    return times;
  }

  /** Adds the end of a time, and before it what lies between. */
  private static void halve(Mover mover, double begin, double end, int halves, List<Double> times) {
    double middle = (begin + end) / 2;
    Road.Place one = mover.place().apply(begin);
    Road.Place other = mover.place().apply(end);
    Road.Place between = mover.place().apply(middle);
    double away =
        StrictMath.hypot(
            between.x() - (one.x() + other.x()) / 2, between.y() - (one.y() + other.y()) / 2);
    double turned = Math.abs(between.heading() - (one.heading() + other.heading()) / 2);
    if (halves > 0 && Math.max(away, turned) > NEAR) {
      halve(mover, begin, middle, halves - 1, times);
      halve(mover, middle, end, halves - 1, times);
    } else {
      times.add(end);
    }
  }

  /** Returns the action that leads along a straight line from the start, at any speed. */
  static Markup straight(Mover mover, String name, double length) {
    Road.Place start = mover.place().apply(0.0);
    List<Markup> vertices = List.of(vertex(start), vertex(start.ahead(length)));
    return action(name, vertices, new Markup("None"));
  }

  private static Markup vertex(Road.Place place) {
    return new Markup("Vertex").add(RoadFrame.worldPosition(place));
  }

  private static Markup action(String name, List<Markup> vertices, Markup time) {
    Markup shape = new Markup("Shape").add(new Markup("Polyline").add(vertices));
    Markup trajectory =
        new Markup("Trajectory").with("name", name).with("closed", "false").add(shape);
    Markup follow =
        new Markup("FollowTrajectoryAction")
            .add(
                new Markup("TimeReference").add(time),
                new Markup("TrajectoryFollowingMode").with("followingMode", "position"),
                new Markup("TrajectoryRef").add(trajectory));
    return new Markup("PrivateAction").add(new Markup("RoutingAction").add(follow));
  }
}
