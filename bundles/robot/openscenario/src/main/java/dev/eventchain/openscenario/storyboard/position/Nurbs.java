package dev.eventchain.openscenario.storyboard.position;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.world.Pose;
import java.util.ArrayList;
import java.util.List;

/**
 * Rational B-splines. Positions and times of the control points are blended alike (de Boor's
 * algorithm on homogeneous coordinates), and the curve is followed from sample to sample.
 */
final class Nurbs {

  private static final int SAMPLES_A_SPAN = 200;

  private final int order;
  private final double[] knots;

  /** Homogeneous coordinates of the control points: x, y, z, time, weight. */
  private final List<double[]> points;

  private Nurbs(int order, double[] knots, List<double[]> points) {
    this.order = order;
    this.knots = knots;
    this.points = points;
  }

  static Path path(ScenarioElement shape, Scene scene) {
    List<ScenarioElement> controls = shape.children("ControlPoint");
    double[] knots =
        shape.children("Knot").stream().mapToDouble(each -> each.number("value")).toArray();
    int order = shape.integer("order");
    if (order < 2 || controls.size() < order || knots.length != controls.size() + order) {
      throw Trajectory.wrong(
          shape,
          "A NURBS of order "
              + order
              + " needs at least as many control points, and as many knots as both together: it has "
              + controls.size()
              + " and "
              + knots.length
              + ".");
    }
    double[] times = Trajectory.times(controls.stream());
    List<double[]> points = new ArrayList<>();
    for (int i = 0; i < controls.size(); i++) {
      ScenarioElement each = controls.get(i);
      Pose pose = Positions.read(each.required("Position")).in(scene).pose();
      double weight = each.number("weight", 1);
      double time = times.length > 0 ? times[i] : 0;
      points.add(
          new double[] {
            weight * pose.x(), weight * pose.y(), weight * pose.z(), weight * time, weight
          });
    }
    return new Nurbs(order, knots, points).sampled(times.length > 0);
  }

  private Path sampled(boolean timed) {
    double first = knots[order - 1];
    double last = knots[points.size()];
    int count = SAMPLES_A_SPAN * (points.size() - order + 1);
    List<Pose> poses = new ArrayList<>();
    double[] times = new double[timed ? count + 1 : 0];
    for (int i = 0; i <= count; i++) {
      double[] at = at(first + (last - first) * i / count);
      poses.add(new Pose(at[0] / at[4], at[1] / at[4], at[2] / at[4], 0, 0, 0));
      if (timed) {
        times[i] = at[3] / at[4];
      }
    }
    return new Polyline(poses, times);
  }

  private double[] at(double parameter) {
    int span = order - 1;
    while (span < points.size() - 1 && knots[span + 1] <= parameter) {
      span++;
    }
    double[][] blended = new double[order][];
    for (int i = 0; i < order; i++) {
      blended[i] = points.get(span - order + 1 + i).clone();
    }
    for (int level = 1; level < order; level++) {
      for (int i = order - 1; i >= level; i--) {
        double low = knots[span - order + 1 + i];
        double high = knots[span + 1 + i - level];
        double share = high > low ? (parameter - low) / (high - low) : 0;
        for (int k = 0; k < blended[i].length; k++) {
          blended[i][k] = (1 - share) * blended[i - 1][k] + share * blended[i][k];
        }
      }
    }
    return blended[order - 1];
  }
}
