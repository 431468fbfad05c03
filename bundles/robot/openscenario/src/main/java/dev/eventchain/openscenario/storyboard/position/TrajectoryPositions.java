package dev.eventchain.openscenario.storyboard.position;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.world.Pose;

/**
 * Positions in the coordinates of a trajectory: s along it, t to its left. Relative orientations
 * count from its direction, whatever orientations its points have.
 */
final class TrajectoryPositions {

  private TrajectoryPositions() {}

  static Position read(ScenarioElement position) {
    Trajectory trajectory = Trajectory.of(position);
    double s = position.number("s");
    double t = position.number("t", 0);
    return scene -> {
      Path path = trajectory.in(scene);
      if (!(s >= 0 && s <= path.length())) {
        throw RoadPositions.none(
            position,
            "The trajectory is " + path.length() + " m long; s = " + s + " m is not on it.");
      }
      Pose place = path.pose(s).withHeading(path.direction(s)).moved(0, t);
      return new Placement(Orientation.of(position).at(place, place), scene.roads().find(place));
    };
  }
}
