package dev.eventchain.openscenario.storyboard.position;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.scene.LaneWay;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.world.LanePoint;
import dev.eventchain.openscenario.storyboard.world.Pose;
import dev.eventchain.openscenario.storyboard.world.RoadMap;
import java.util.List;
import java.util.Optional;

/**
 * Positions in the coordinates of a lane. Relative orientations count from the direction in which
 * the lane is driven. What is relative to an entity counts as it faces: lanes and offsets to its
 * left, distances ahead of it.
 */
final class LanePositions {

  private LanePositions() {}

  static Position absolute(ScenarioElement position) {
    return scene ->
        at(
            scene,
            position,
            new LanePoint(
                position.text("roadId"),
                lane(position),
                position.number("s"),
                position.number("offset", 0)));
  }

  /** Reads the number of a lane. */
  static int lane(ScenarioElement position) {
    String lane = position.text("laneId");
    try {
      return Integer.parseInt(lane);
    } catch (NumberFormatException e) {
      throw RoadPositions.none(position, "'" + lane + "' is not the number of a lane.");
    }
  }

  static Position relative(ScenarioElement position) {
    return scene -> {
      RoadPositions.ofEntity(scene, position);
      LaneWay from = LaneWay.of(scene, scene.state(position.text("entityRef"))).orElseThrow();
      double offset = position.number("offset", 0);
      LaneWay there = ahead(scene, position, from);
      int lane = beside(scene, position, there);
      LanePoint point = there.point();
      return at(
          scene,
          position,
          new LanePoint(point.road(), lane, point.s(), there.alongS() ? offset : -offset));
    };
  }

  private static LaneWay ahead(Scene scene, ScenarioElement position, LaneWay from) {
    if (position.has("dsLane")) {
      return moved(scene, position, from, position.number("dsLane"));
    }
    double ds = position.number("ds", 0);
    LanePoint point = from.point();
    double s = point.s() + (from.alongS() ? ds : -ds);
    if (s >= 0 && s <= scene.roads().length(point.road())) {
      return new LaneWay(
          new LanePoint(point.road(), point.lane(), s, point.offset()), from.alongS());
    }
    return moved(scene, position, from, ds);
  }

  private static LaneWay moved(
      Scene scene, ScenarioElement position, LaneWay from, double distance) {
    Optional<LaneWay> there = from.moved(scene, distance, List.of());
    return there.orElseThrow(
        () ->
            RoadPositions.none(
                position, "The road ends before " + distance + " m from the entity."));
  }

  /** Returns the number of the lane to the left or right. */
  private static int beside(Scene scene, ScenarioElement position, LaneWay from) {
    int lanes = position.integer("dLane");
    return from.beside(scene, lanes)
        .orElseThrow(
            () ->
                RoadPositions.none(
                    position, "There is no lane " + lanes + " to the left of the entity's."));
  }

  private static Placement at(Scene scene, ScenarioElement position, LanePoint point) {
    RoadMap roads = scene.roads();
    requireLane(scene, position, point);
    Pose road = roads.pose(roads.road(point));
    boolean alongS = roads.goesAlongS(point.road(), point.s(), point.lane());
    Pose driven = alongS ? road : road.withHeading(road.heading() + Math.PI);
    return new Placement(Orientation.of(position).at(driven, driven), Optional.of(point));
  }

  /** Refuses a road or a lane that is not there, and an s beyond the road's ends. */
  static void requireLane(Scene scene, ScenarioElement position, LanePoint point) {
    RoadMap roads = scene.roads();
    RoadPositions.checkOnRoad(scene, position, point.road(), point.s());
    if (!roads.lanes(point.road(), point.s()).contains(point.lane())) {
      throw RoadPositions.none(
          position,
          "Road '"
              + point.road()
              + "' has no lane "
              + point.lane()
              + " at s = "
              + point.s()
              + " m; it has "
              + roads.lanes(point.road(), point.s())
              + ".");
    }
  }
}
