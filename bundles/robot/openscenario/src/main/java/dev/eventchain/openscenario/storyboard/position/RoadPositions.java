package dev.eventchain.openscenario.storyboard.position;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.world.LanePoint;
import dev.eventchain.openscenario.storyboard.world.Pose;
import dev.eventchain.openscenario.storyboard.world.RoadPoint;
import dev.eventchain.openscenario.storyboard.world.StoryboardRules;

/** Positions in the coordinates of a road. Relative orientations count from the direction of s. */
final class RoadPositions {

  private RoadPositions() {}

  static Position absolute(ScenarioElement position) {
    return scene ->
        at(
            scene,
            position,
            new RoadPoint(position.text("roadId"), position.number("s"), position.number("t")));
  }

  static Position relative(ScenarioElement position) {
    return scene -> {
      RoadPoint from = scene.roads().road(ofEntity(scene, position));
      return at(
          scene,
          position,
          new RoadPoint(
              from.road(), from.s() + position.number("ds"), from.t() + position.number("dt")));
    };
  }

  private static Placement at(Scene scene, ScenarioElement position, RoadPoint point) {
    checkOnRoad(scene, position, point.road(), point.s());
    Pose road = scene.roads().pose(point);
    return new Placement(Orientation.of(position).at(road, road), scene.roads().find(road));
  }

  /** Refuses a road that is not there, and an s beyond its ends. */
  static void checkOnRoad(Scene scene, ScenarioElement position, String road, double s) {
    if (!scene.roads().hasRoad(road)) {
      throw none(position, "There is no road '" + road + "'.");
    }
    double length = scene.roads().length(road);
    if (!(s >= 0 && s <= length)) {
      throw none(
          position, "Road '" + road + "' is " + length + " m long; s = " + s + " m is not on it.");
    }
  }

  static DiagnosticException none(ScenarioElement position, String message) {
    return StoryboardRules.failure(
        StoryboardRules.NO_PLACE,
        message,
        position.location(),
        "Correct the " + position.name() + ", or use the road network that it was written for.");
  }

  /** Returns where the entity is that a position is relative to. */
  static LanePoint ofEntity(Scene scene, ScenarioElement position) {
    String entity = position.text("entityRef");
    return scene
        .state(entity)
        .road()
        .orElseThrow(
            () ->
                none(
                    position,
                    "'" + entity + "' is on no road, to which the position is relative."));
  }
}
