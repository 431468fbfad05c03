package dev.eventchain.simulation.stage;

import dev.eventchain.roads.LanePath;
import dev.eventchain.roads.LanePosition;
import dev.eventchain.roads.RoadNetwork;
import dev.eventchain.simulation.world.Road;
import java.util.Optional;

/**
 * The furnished road of a scenario that was exported: with walls and posts, which are part of it
 * and no objects of their own, so that sensors see what they saw.
 */
public final class FurnishedRoad {

  /** The code of the {@code userData} by which an exported file says it of its road. */
  public static final String CODE = "eventchain-furnished";

  private FurnishedRoad() {}

  /**
   * Returns the road of a network; empty if it does not say that it is a furnished one.
   *
   * @param path along the ego's lane
   * @param start of the road on the path, in m
   */
  static Optional<Road> of(RoadNetwork network, LanePath path, double start) {
    LanePosition lane = path.lanePosition(start);
    return network
        .road(lane.road())
        .filter(road -> network.roads().size() == 1)
        .filter(road -> road.userData(CODE).filter("true"::equals).isPresent())
        .map(
            road ->
                Road.bend(
                    path.curvature(start), road.section(lane.s()).width(lane.lane(), lane.s())));
  }
}
