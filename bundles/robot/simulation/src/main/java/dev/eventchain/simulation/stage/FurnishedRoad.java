package dev.eventchain.simulation.stage;

import dev.eventchain.roads.LanePath;
import dev.eventchain.roads.LanePosition;
import dev.eventchain.roads.RoadNetwork;
import dev.eventchain.roads.RoadObject;
import dev.eventchain.simulation.world.Road;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * The furnished road of a scenario that was exported: with walls and posts, which are part of it
 * and no objects of their own, so that sensors see what they saw.
 */
final class FurnishedRoad {

  /** How an exported file names the program and the walls. */
  private static final String VENDOR = "Eventchain";

  private static final Set<String> WALLS = Set.of("left wall", "right wall");

  private FurnishedRoad() {}

  /**
   * Returns the road of a network; empty if it is not an exported one.
   *
   * @param path along the ego's lane
   * @param start of the road on the path, in m
   */
  static Optional<Road> of(RoadNetwork network, LanePath path, double start) {
    List<dev.eventchain.roads.Road> roads = List.copyOf(network.roads());
    boolean exported = network.header().vendor().equals(VENDOR) && roads.size() == 1;
    if (!exported) {
      return Optional.empty();
    }
    dev.eventchain.roads.Road only = roads.get(0);
    Set<String> names = only.objects().stream().map(RoadObject::name).collect(Collectors.toSet());
    LanePosition lane = path.lanePosition(start);
    return names.containsAll(WALLS)
        ? Optional.of(
            Road.bend(path.curvature(start), only.section(lane.s()).width(lane.lane(), lane.s())))
        : Optional.empty();
  }
}
