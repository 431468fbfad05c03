package dev.eventchain.simulation.export;

import dev.eventchain.simulation.world.Road;
import java.util.ArrayList;
import java.util.List;

/** Trajectories as lines from vertex to vertex on the map. */
final class Trajectory {

  /** Largest time between two vertices, in s: straight lines are within 1 cm of an arc then. */
  private static final double STEP = 0.1;

  private Trajectory() {}

  /** Returns the action that leads through the places of a time, at their times. */
  static Markup timed(Mover mover, String name, Timeline.Span span) {
    int steps = (int) Math.max(1, Math.ceil((span.to() - span.from()) / STEP - 1e-9));
    List<Markup> vertices = new ArrayList<>();
    for (int i = 0; i <= steps; i++) {
      double since = i == steps ? span.to() - span.from() : i * STEP;
      Road.Place place = mover.place().apply(span.from() + since);
      vertices.add(vertex(place).with("time", since));
    }
    Markup timing =
        new Markup("Timing")
            .with("domainAbsoluteRelative", "relative")
            .with("scale", 1.0)
            .with("offset", 0.0);
    return action(name, vertices, timing);
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
