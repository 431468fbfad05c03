package dev.eventchain.simulation.stage;

import dev.eventchain.openscenario.storyboard.world.LanePoint;
import dev.eventchain.openscenario.storyboard.world.Pose;
import dev.eventchain.openscenario.storyboard.world.RoadMap;
import dev.eventchain.openscenario.storyboard.world.RoadPoint;
import dev.eventchain.roads.LanePath;
import dev.eventchain.roads.LanePosition;
import dev.eventchain.roads.Road;
import dev.eventchain.roads.RoadNetwork;
import dev.eventchain.roads.RoadPosition;
import dev.eventchain.roads.Route;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/** The roads of an OpenDRIVE file, as a storyboard asks for them. */
record NetworkRoads(RoadNetwork network) implements RoadMap {

  /** How much further a path is followed than asked, in m. */
  private static final double BEYOND = 1.0;

  private Road road(String id) {
    return network.road(id).orElseThrow();
  }

  @Override
  public boolean hasRoad(String road) {
    return network.road(road).isPresent();
  }

  @Override
  public double length(String road) {
    return road(road).length();
  }

  @Override
  public List<Integer> lanes(String road, double s) {
    return road(road).laneIds(s).stream()
        .filter(lane -> lane != 0)
        .sorted(Comparator.reverseOrder())
        .toList();
  }

  @Override
  public double centre(String road, double s, int lane) {
    return road(road).section(s).centre(lane, s);
  }

  @Override
  public boolean goesAlongS(String road, double s, int lane) {
    return road(road).leads(road(road).lane(s, lane).orElseThrow(), true);
  }

  @Override
  public Pose pose(RoadPoint point) {
    dev.eventchain.roads.Pose pose = road(point.road()).pose(point.s(), point.t());
    return new Pose(pose.x(), pose.y(), pose.z(), pose.heading(), pose.pitch(), pose.roll());
  }

  @Override
  public Optional<LanePoint> find(Pose place) {
    return network
        .locate(place.x(), place.y())
        .filter(found -> found.lane().isPresent() && found.lane().getAsInt() != 0)
        .map(this::lane);
  }

  private LanePoint lane(RoadPosition found) {
    int lane = found.lane().getAsInt();
    double centre = centre(found.road(), found.s(), lane);
    return new LanePoint(found.road(), lane, found.s(), found.t() - centre);
  }

  @Override
  public Optional<Moved> move(
      LanePoint from, boolean alongS, double distance, List<RoadPoint> route) {
    boolean forward = distance >= 0.0;
    double way = Math.abs(distance);
    LanePosition start = new LanePosition(from.road(), from.lane(), from.s(), 0.0);
    return network
        .path(start, alongS == forward, 0.0, way + BEYOND)
        .filter(path -> path.length() - path.origin() >= way)
        .map(path -> moved(path, path.origin() + way, from.offset(), forward));
  }

  private static Moved moved(LanePath path, double along, double offset, boolean forward) {
    LanePosition at = path.lanePosition(along);
    LanePoint point = new LanePoint(at.road(), at.lane(), at.s(), offset);
    return new Moved(point, path.isAlongS(along) == forward);
  }

  @Override
  public OptionalDouble along(RoadPoint from, RoadPoint to) {
    if (from.road().equals(to.road())) {
      return OptionalDouble.of(from.s() - to.s());
    }
    Optional<Route> route = network.route(List.of(position(to), position(from)));
    return route.isPresent()
        ? OptionalDouble.of(route.get().length())
        : network
            .route(List.of(position(from), position(to)))
            .map(back -> OptionalDouble.of(-back.length()))
            .orElse(OptionalDouble.empty());
  }

  private LanePosition position(RoadPoint point) {
    LanePoint lane = lane(point);
    return new LanePosition(lane.road(), lane.lane(), lane.s(), lane.offset());
  }
}
