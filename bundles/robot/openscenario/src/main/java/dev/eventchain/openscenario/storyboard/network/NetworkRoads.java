package dev.eventchain.openscenario.storyboard.network;

import dev.eventchain.openscenario.storyboard.world.Angles;
import dev.eventchain.openscenario.storyboard.world.LanePoint;
import dev.eventchain.openscenario.storyboard.world.Pose;
import dev.eventchain.openscenario.storyboard.world.RoadMap;
import dev.eventchain.openscenario.storyboard.world.RoadPoint;
import dev.eventchain.roads.LanePath;
import dev.eventchain.roads.LanePosition;
import dev.eventchain.roads.RoadNetwork;
import dev.eventchain.roads.RoadPosition;
import dev.eventchain.roads.Route;
import dev.eventchain.roads.road.Road;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/** The roads of a network. */
public final class NetworkRoads implements RoadMap {

  private final RoadNetwork network;

  public NetworkRoads(RoadNetwork network) {
    this.network = network;
  }

  private Road found(String road) {
    return network.road(road).orElseThrow(() -> new IllegalArgumentException("no road " + road));
  }

  @Override
  public boolean hasRoad(String road) {
    return network.road(road).isPresent();
  }

  @Override
  public double length(String road) {
    return found(road).length();
  }

  @Override
  public List<Integer> lanes(String road, double s) {
    return found(road).laneIds(s);
  }

  @Override
  public double centre(String road, double s, int lane) {
    return found(road).section(s).centre(lane, s);
  }

  @Override
  public boolean goesAlongS(String road, double s, int lane) {
    Road on = found(road);
    return on.lane(s, lane).map(each -> on.leads(each, true)).orElse(lane < 0);
  }

  @Override
  public Pose pose(RoadPoint point) {
    return pose(found(point.road()).pose(point.s(), point.t()));
  }

  private static Pose pose(dev.eventchain.roads.road.Pose pose) {
    return new Pose(pose.x(), pose.y(), pose.z(), 0, pose.pitch(), pose.roll())
        .withHeading(pose.heading());
  }

  @Override
  public Optional<LanePoint> find(Pose place) {
    Optional<RoadPosition> position = network.locate(place.x(), place.y());
    return position
        .filter(each -> !lanes(each.road(), each.s()).isEmpty())
        .map(each -> lane(new RoadPoint(each.road(), each.s(), each.t())));
  }

  @Override
  public Optional<Moved> move(
      LanePoint from, boolean alongS, double distance, List<RoadPoint> route) {
    Road road = found(from.road());
    double t = road(from).t();
    double sense = alongS ? 1 : -1;
    double middle = within(road, from.s() + sense * distance / 2);
    // Beside a bent line, the way is shorter or longer than along it.
    double s = from.s() + sense * distance / (1 - road.curvature(middle) * t);
    boolean same =
        s >= 0 && s <= road.length() && road.section(s).start() == road.section(from.s()).start();
    if (same) {
      return Optional.of(
          new Moved(new LanePoint(from.road(), from.lane(), s, from.offset()), alongS));
    }
    LanePosition position = new LanePosition(from.road(), from.lane(), from.s(), from.offset());
    double heading = road.heading(from.s()) + (alongS ? 0 : Math.PI);
    Optional<LanePosition> there = Optional.empty();
    if (!route.isEmpty() && distance > 0) {
      there = onRoute(from, distance, route);
    }
    return there
        .or(() -> network.relative(position, 0, s - from.s()))
        .map(each -> moved(each, heading));
  }

  private static double within(Road road, double s) {
    return Math.max(0, Math.min(road.length(), s));
  }

  /** Returns a place that is reached by a short way with a heading. */
  private Moved moved(LanePosition there, double heading) {
    double along = found(there.road()).heading(there.s());
    return new Moved(
        new LanePoint(there.road(), there.lane(), there.s(), there.offset()),
        Angles.between(along, heading) <= Math.PI / 2);
  }

  /** Returns the place on the way to the waypoint that is nearest along the roads. */
  private Optional<LanePosition> onRoute(
      LanePoint from, double distance, List<RoadPoint> waypoints) {
    Optional<Route> shortest = Optional.empty();
    for (RoadPoint each : waypoints) {
      Optional<Route> way =
          each.road().equals(from.road())
              ? Optional.empty()
              : network.route(List.of(position(from), position(lane(each))));
      if (way.isPresent() && (shortest.isEmpty() || way.get().length() < shortest.get().length())) {
        shortest = way;
      }
    }
    return shortest
        .flatMap(way -> network.path(position(from), way, 0))
        .map(path -> place(path, from, distance));
  }

  private static LanePosition place(LanePath path, LanePoint from, double distance) {
    double along = path.origin() + distance;
    LanePosition middle = path.lanePosition(along);
    boolean turned = path.isAlongS(along) != path.isAlongS(path.origin());
    return new LanePosition(
        middle.road(), middle.lane(), middle.s(), turned ? -from.offset() : from.offset());
  }

  private static LanePosition position(LanePoint point) {
    return new LanePosition(point.road(), point.lane(), point.s(), 0);
  }

  @Override
  public List<Stretch> way(List<LanePoint> waypoints) {
    return network.route(waypoints.stream().map(NetworkRoads::position).toList()).stream()
        .flatMap(route -> route.legs().stream())
        .map(leg -> new Stretch(leg.road(), leg.alongS(), leg.from(), leg.to()))
        .toList();
  }

  @Override
  public Optional<String> geoProblem() {
    return network.geoProblem();
  }

  @Override
  public Pose geo(double latitude, double longitude, double altitude) {
    return pose(network.geo(latitude, longitude, altitude));
  }

  @Override
  public OptionalDouble along(RoadPoint from, RoadPoint to) {
    if (from.road().equals(to.road())) {
      return OptionalDouble.of(to.s() - from.s());
    }
    LanePosition start = position(lane(from));
    LanePosition end = position(lane(to));
    List<Double> ways = new ArrayList<>();
    network
        .route(List.of(start, end))
        .ifPresent(way -> ways.add(way.legs().get(0).alongS() ? way.length() : -way.length()));
    network
        .route(List.of(end, start))
        .ifPresent(
            way ->
                ways.add(
                    way.legs().get(way.legs().size() - 1).alongS() ? -way.length() : way.length()));
    return ways.stream()
        .min((first, second) -> Double.compare(Math.abs(first), Math.abs(second)))
        .map(OptionalDouble::of)
        .orElseGet(OptionalDouble::empty);
  }
}
