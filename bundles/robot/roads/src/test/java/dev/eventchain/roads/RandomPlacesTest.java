package dev.eventchain.roads;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.roads.road.Lane;
import dev.eventchain.roads.road.LaneSection;
import dev.eventchain.roads.road.Pose;
import dev.eventchain.roads.road.Road;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.TreeMap;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

/** Random places on all networks, there and back. */
class RandomPlacesTest {

  private static final double MILLIMETRE = 1e-3;

  private static final int PARTS = 1_000_000;

  private static double share(int parts) {
    return (double) parts / PARTS;
  }

  private static final Map<String, RoadNetwork> NETWORKS = new TreeMap<>();

  static {
    for (String name : List.of("curves", "parametric", "crossing", "leaving", "tilted")) {
      NETWORKS.put(name, Networks.read(name));
    }
  }

  private static RoadNetwork network(int choice) {
    return List.copyOf(NETWORKS.values()).get(Math.floorMod(choice, NETWORKS.size()));
  }

  private static Road road(RoadNetwork network, int choice) {
    return List.copyOf(network.roads()).get(Math.floorMod(choice, network.roads().size()));
  }

  private static <T> T chosen(List<T> from, int choice) {
    return from.get(Math.floorMod(choice, from.size()));
  }

  @Property
  void placesAreLocatedWhereTheyAre(
      @ForAll @IntRange(max = 1000) int first,
      @ForAll @IntRange(max = 1000) int second,
      @ForAll @IntRange(max = PARTS) int along,
      @ForAll @IntRange(min = 1, max = PARTS - 1) int across) {
    RoadNetwork network = network(first);
    Road road = road(network, second);
    double s = share(along) * road.length();
    LaneSection section = road.section(s);
    double t = section.rightEdge(s) + share(across) * (section.leftEdge(s) - section.rightEdge(s));
    Pose pose = road.pose(s, t);
    RoadPosition near = new RoadPosition(road.id(), 0, 0, OptionalInt.empty());
    RoadPosition found = network.locate(pose.x(), pose.y(), near).orElseThrow();
    assertEquals(road.id(), found.road());
    assertEquals(s, found.s(), MILLIMETRE);
    assertEquals(t, found.t(), MILLIMETRE);
    RoadPosition any = network.locate(pose.x(), pose.y()).orElseThrow();
    Pose there = network.road(any.road()).orElseThrow().pose(any.s(), any.t());
    assertEquals(0, Math.hypot(there.x() - pose.x(), there.y() - pose.y()), MILLIMETRE);
    RoadPosition nearest = network.nearest(pose.x(), pose.y());
    assertTrue(nearest.lane().isPresent());
  }

  @Property
  void edgesOfLanesAreInOrder(
      @ForAll @IntRange(max = 1000) int first,
      @ForAll @IntRange(max = 1000) int second,
      @ForAll @IntRange(max = PARTS) int along) {
    Road road = road(network(first), second);
    double s = share(along) * road.length();
    LaneSection section = road.section(s);
    double last = section.leftEdge(s);
    for (Lane lane : section.lanes()) {
      double right =
          lane.id() > 0 ? section.innerEdge(lane.id(), s) : section.outerEdge(lane.id(), s);
      assertTrue(right <= last + 1e-9, road.id() + " " + lane.id());
      last = right;
      if (lane.id() != 0 && section.width(lane.id(), s) > 1e-6) {
        assertEquals(OptionalInt.of(lane.id()), road.laneAt(s, section.centre(lane.id(), s)));
      }
    }
  }

  @Property
  void pathsAreContinuousAndStationsTheirInverse(
      @ForAll @IntRange(max = 1000) int first,
      @ForAll @IntRange(max = 1000) int second,
      @ForAll @IntRange(max = 1000) int third,
      @ForAll @IntRange(max = PARTS) int along,
      @ForAll @IntRange(min = -1500, max = 1500) int acrossMillimetres) {
    RoadNetwork network = network(first);
    Road road = road(network, second);
    double s = share(along) * road.length();
    int lane = chosen(road.laneIds(s), third);
    LanePosition position = new LanePosition(road.id(), lane, s, 0);
    LanePath path = network.path(position, 100, 150).orElseThrow();
    Pose middle = network.pose(position).orElseThrow();
    Pose origin = path.pose(path.origin(), 0);
    assertEquals(0, Math.hypot(origin.x() - middle.x(), origin.y() - middle.y()), MILLIMETRE);
    assertEquals(middle.z(), origin.z(), MILLIMETRE);
    double at = share(along) * path.length();
    double across = acrossMillimetres * MILLIMETRE;
    Pose pose = path.pose(at, across);
    LanePath.Station station = path.station(pose.x(), pose.y(), at + 3);
    assertEquals(at, station.along(), MILLIMETRE);
    assertEquals(across, station.across(), MILLIMETRE);
    assertEquals(at, path.station(pose.x(), pose.y(), Double.NaN).along(), MILLIMETRE);
    double step = Math.min(0.01, path.length() - at);
    Pose next = path.pose(at + step, 0);
    Pose here = path.pose(at, 0);
    assertEquals(step, Math.hypot(next.x() - here.x(), next.y() - here.y()), 1e-3);
  }
}
