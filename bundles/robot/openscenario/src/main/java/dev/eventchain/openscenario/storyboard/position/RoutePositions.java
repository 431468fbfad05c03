package dev.eventchain.openscenario.storyboard.position;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.world.LanePoint;
import dev.eventchain.openscenario.storyboard.world.Pose;
import dev.eventchain.openscenario.storyboard.world.RoadMap;
import dev.eventchain.openscenario.storyboard.world.RoadPoint;
import dev.eventchain.openscenario.storyboard.world.RouteSides;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Positions on a route, which begins at its first waypoint and takes the shortest way over the
 * others. Relative orientations count from the direction of the route.
 */
public final class RoutePositions {

  /** A place on a route: a road, its s, and whether the route leads along it. */
  private record Reached(String road, double s, boolean alongS) {}

  private final ScenarioElement position;
  private final ScenarioElement place;
  private final ScenarioElement route;
  private final List<Position> waypoints = new ArrayList<>();

  private RoutePositions(ScenarioElement position) {
    this.position = position;
    place = position.required("InRoutePosition").choice();
    route = position.required("RouteRef").required("Route");
    for (ScenarioElement each : route.children("Waypoint")) {
      waypoints.add(Positions.read(each.required("Position")));
    }
    if (route.flag("closed", false)) {
      waypoints.add(waypoints.get(0));
    }
  }

  static Position read(ScenarioElement position) {
    return new RoutePositions(position)::in;
  }

  /**
   * Returns whether it depends on {@link RouteSides} where a position is.
   *
   * @param isRelative whether the route depends on entities, which may have no place yet
   */
  public static boolean isTwofold(ScenarioElement position, Scene scene, boolean isRelative) {
    RoutePositions read = new RoutePositions(position);
    boolean beside =
        switch (read.place.name()) {
          case "FromRoadCoordinates" -> read.place.number("t") != 0;
          case "FromLaneCoordinates" -> true;
          default -> false;
        };
    return beside && (isRelative || !read.reached(scene, read.place.number("pathS")).alongS());
  }

  private Placement in(Scene scene) {
    return switch (place.name()) {
      case "FromRoadCoordinates" -> {
        Reached at = reached(scene, place.number("pathS"));
        double t = place.number("t");
        yield placed(scene, at, new RoadPoint(at.road(), at.s(), isMirrored(scene, at) ? -t : t));
      }
      case "FromLaneCoordinates" -> onLane(scene, reached(scene, place.number("pathS")));
      case "FromCurrentEntity" -> ofEntity(scene);
      default -> throw new IllegalArgumentException(place.name() + " is not supported");
    };
  }

  private static boolean isMirrored(Scene scene, Reached at) {
    return !at.alongS() && scene.routeSides() == RouteSides.ROUTE;
  }

  private Placement onLane(Scene scene, Reached at) {
    int sign = isMirrored(scene, at) ? -1 : 1;
    int lane = sign * LanePositions.lane(place);
    LanePoint point = new LanePoint(at.road(), lane, at.s(), sign * place.number("laneOffset", 0));
    LanePositions.requireLane(scene, place, point);
    return new Placement(placed(scene, at, scene.roads().road(point)).pose(), Optional.of(point));
  }

  private Placement placed(Scene scene, Reached at, RoadPoint point) {
    Pose road = scene.roads().pose(point);
    Pose along = at.alongS() ? road : road.withHeading(road.heading() + Math.PI);
    // Where roads cross, it is on that of the route.
    Optional<LanePoint> lane = scene.roads().find(road).map(found -> scene.roads().lane(point));
    return new Placement(Orientation.of(position).at(along, along), lane);
  }

  /** Returns where an entity is, which has to be on a road of the route. */
  private Placement ofEntity(Scene scene) {
    RoadPoint point = scene.roads().road(RoadPositions.ofEntity(scene, place));
    return way(scene).stream()
        .filter(each -> each.road().equals(point.road()) && isOn(each, point.s()))
        .findFirst()
        .map(each -> placed(scene, new Reached(point.road(), point.s(), each.alongS()), point))
        .orElseThrow(
            () ->
                RoadPositions.none(
                    position, "'" + place.text("entityRef") + "' is not on the route."));
  }

  private static boolean isOn(RoadMap.Stretch stretch, double s) {
    return s >= Math.min(stretch.from(), stretch.to())
        && s <= Math.max(stretch.from(), stretch.to());
  }

  private Reached reached(Scene scene, double pathS) {
    double left = pathS;
    List<RoadMap.Stretch> way = way(scene);
    for (RoadMap.Stretch each : way) {
      if (left >= 0 && left <= each.length()) {
        double s = each.from() + (each.alongS() ? left : -left);
        return new Reached(each.road(), s, each.alongS());
      }
      left -= each.length();
    }
    double length = way.stream().mapToDouble(RoadMap.Stretch::length).sum();
    throw RoadPositions.none(
        position, "The route is " + length + " m long; pathS = " + pathS + " m is not on it.");
  }

  private List<RoadMap.Stretch> way(Scene scene) {
    List<LanePoint> points = new ArrayList<>();
    for (Position each : waypoints) {
      each.in(scene).road().ifPresent(points::add);
    }
    if (points.size() < waypoints.size()) {
      throw RoadPositions.none(route, "A waypoint of the route is on no road.");
    }
    List<RoadMap.Stretch> way = scene.roads().way(points);
    if (way.isEmpty()) {
      throw RoadPositions.none(
          route, "No way leads over the waypoints of the route in the direction of traffic.");
    }
    return way;
  }
}
