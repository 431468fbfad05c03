package dev.eventchain.openscenario.storyboard.position;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.world.LanePoint;
import dev.eventchain.openscenario.storyboard.world.Pose;
import dev.eventchain.openscenario.storyboard.world.RoadMap;
import dev.eventchain.openscenario.storyboard.world.StoryboardRules;
import java.util.Optional;

/** Positions in the coordinates of the world or of an entity. */
final class WorldPositions {

  private WorldPositions() {}

  static Position absolute(ScenarioElement position) {
    Pose pose =
        new Pose(
            position.number("x"),
            position.number("y"),
            position.number("z", Double.NaN),
            position.number("h", 0),
            position.number("p", 0),
            position.number("r", 0));
    return scene -> grounded(scene, pose);
  }

  /** Puts a pose without a height on the road, or at height 0 beside it. */
  private static Placement grounded(Scene scene, Pose pose) {
    Optional<LanePoint> road = scene.roads().find(pose);
    RoadMap roads = scene.roads();
    double ground = road.map(point -> roads.pose(roads.road(point)).z()).orElse(0.0);
    double z = Double.isNaN(pose.z()) ? ground : pose.z();
    return new Placement(
        new Pose(pose.x(), pose.y(), z, 0, pose.pitch(), pose.roll()).withHeading(pose.heading()),
        road);
  }

  static Position relative(ScenarioElement position) {
    return scene -> {
      Pose reference = scene.state(position.text("entityRef")).pose();
      Pose place =
          new Pose(
              reference.x() + position.number("dx"),
              reference.y() + position.number("dy"),
              reference.z() + position.number("dz", 0),
              0,
              0,
              0);
      return grounded(scene, Orientation.of(position).at(place, reference));
    };
  }

  static Position ofObject(ScenarioElement position) {
    return scene -> {
      Pose reference = scene.state(position.text("entityRef")).pose();
      Pose moved = reference.moved(position.number("dx"), position.number("dy"));
      Pose place = new Pose(moved.x(), moved.y(), moved.z() + position.number("dz", 0), 0, 0, 0);
      return grounded(scene, Orientation.of(position).at(place, reference));
    };
  }

  /** Degrees of 1.2 and later, or radians of 1.1, as the standard has it. */
  static Position geo(ScenarioElement position) {
    double latitude =
        position.number("latitudeDeg", Math.toDegrees(position.number("latitude", 0)));
    double longitude =
        position.number("longitudeDeg", Math.toDegrees(position.number("longitude", 0)));
    double altitude = position.number("altitude", position.number("height", Double.NaN));
    return scene -> {
      Optional<String> problem = scene.roads().geoProblem();
      if (problem.isPresent()) {
        throw StoryboardRules.failure(
            StoryboardRules.NO_PLACE,
            "A GeoPosition needs the geoReference of the road network: " + problem.get() + ".",
            position.location(),
            "Give the position as a WorldPosition or a LanePosition.");
      }
      if (!(Math.abs(latitude) <= 90)) {
        throw StoryboardRules.failure(
            StoryboardRules.NO_PLACE,
            "There is no latitude of " + latitude + " degrees.",
            position.location(),
            "Give latitude and longitude in rad, latitudeDeg and longitudeDeg in degrees.");
      }
      Pose place = scene.roads().geo(latitude, longitude, altitude);
      return grounded(scene, Orientation.of(position).at(place, place));
    };
  }
}
