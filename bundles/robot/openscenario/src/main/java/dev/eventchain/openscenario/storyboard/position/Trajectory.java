package dev.eventchain.openscenario.storyboard.position;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.world.Pose;
import dev.eventchain.openscenario.storyboard.world.StoryboardRules;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/** A trajectory as it is written. Its positions are found when it begins. */
public final class Trajectory {

  private final ScenarioElement written;
  private final boolean closed;

  private Trajectory(ScenarioElement written) {
    this.written = written;
    closed = written.flag("closed", false);
  }

  /** Reads the trajectory of an action, which has it itself or in a reference. */
  public static Trajectory of(ScenarioElement action) {
    return new Trajectory(
        action
            .child("Trajectory")
            .orElseGet(() -> action.required("TrajectoryRef").required("Trajectory")));
  }

  /** Returns whether its end is its begin. */
  public boolean isClosed() {
    return closed;
  }

  /**
   * Returns its path.
   *
   * @throws DiagnosticException if it has no length, or its times run backward
   */
  public Path in(Scene scene) {
    ScenarioElement shape = written.required("Shape").choice();
    Path path =
        switch (shape.name()) {
          case "Polyline" -> polyline(scene, shape.children("Vertex"));
          case "Clothoid" -> Clothoids.single(shape, start(scene, shape));
          case "ClothoidSpline" -> Clothoids.spline(shape, scene);
          case "Nurbs" -> Nurbs.path(shape, scene);
          default -> throw new IllegalArgumentException(shape.name());
        };
    if (!(path.length() > 0)) {
      throw wrong(shape, "The trajectory has no length.");
    }
    return path;
  }

  private static Pose start(Scene scene, ScenarioElement shape) {
    return Positions.read(shape.required("Position")).in(scene).pose();
  }

  private Path polyline(Scene scene, List<ScenarioElement> vertices) {
    List<Pose> points = new ArrayList<>();
    for (ScenarioElement each : vertices) {
      points.add(start(scene, each));
    }
    if (points.size() < 2) {
      throw wrong(written, "The trajectory has " + points.size() + " vertex, and needs two.");
    }
    double[] times = times(vertices.stream());
    if (closed && times.length == 0) {
      points.add(points.get(0));
    }
    return new Polyline(points, times, vertices.stream().allMatch(Trajectory::isOriented));
  }

  /** Returns whether a vertex says which way an entity looks there. */
  private static boolean isOriented(ScenarioElement vertex) {
    ScenarioElement position = vertex.required("Position").choice();
    return position.has("h") || position.child("Orientation").isPresent();
  }

  /** Returns the times of vertices; none if one of them has none. */
  static double[] times(Stream<ScenarioElement> vertices) {
    List<ScenarioElement> all = vertices.toList();
    if (!all.stream().allMatch(each -> each.has("time"))) {
      return new double[0];
    }
    double before = Double.NEGATIVE_INFINITY;
    for (ScenarioElement each : all) {
      double time = each.number("time");
      if (!(time >= before)) {
        throw StoryboardRules.failure(
            StoryboardRules.TRAJECTORY,
            "The time of a trajectory goes back from " + before + " s to " + time + " s.",
            each.location("time"),
            "Give the points in the order of their times.");
      }
      before = time;
    }
    return all.stream().mapToDouble(each -> each.number("time")).toArray();
  }

  static DiagnosticException wrong(ScenarioElement element, String message) {
    return StoryboardRules.failure(
        StoryboardRules.TRAJECTORY,
        message,
        element.location(),
        "Correct the trajectory, or leave out the action that follows it.");
  }
}
