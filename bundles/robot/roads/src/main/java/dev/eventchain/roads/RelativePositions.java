package dev.eventchain.roads;

import dev.eventchain.roads.link.LaneEnd;
import dev.eventchain.roads.link.LaneWalk;
import dev.eventchain.roads.road.Road;
import java.util.Optional;

/** Positions a number of lanes and a distance away from others. */
final class RelativePositions {

  private final RoadNetwork network;
  private final LaneWalk walk;

  RelativePositions(RoadNetwork network) {
    this.network = network;
    this.walk = new LaneWalk(network.graph());
  }

  /**
   * Returns a position: along the own lane and then sideways, or, where the own lane ends before,
   * sideways first.
   */
  Optional<LanePosition> of(LanePosition from, int lanes, double distance) {
    return along(from, distance, lanes)
        .filter(this::exists)
        .or(
            () ->
                Optional.of(beside(from, lanes))
                    .filter(this::exists)
                    .flatMap(other -> along(other, distance, 0)));
  }

  private boolean exists(LanePosition position) {
    return network.t(position).isPresent();
  }

  private Optional<LanePosition> along(LanePosition from, double distance, int lanes) {
    Road road = network.road(from.road()).orElseThrow();
    boolean up = distance >= 0;
    LaneEnd exit = new LaneEnd(road, road.sectionIndex(from.s()), from.lane(), up);
    return walk.along(
        exit,
        from.s(),
        Math.abs(distance),
        (end, s) -> {
          // On a road whose s runs the other way, left is right.
          int sense = end.atEnd() == up ? 1 : -1;
          LanePosition arrived =
              new LanePosition(end.road().id(), end.lane(), s, sense * from.offset());
          return beside(arrived, sense * lanes);
        });
  }

  /** Returns the position a number of lanes to the left. There is no lane 0 to count. */
  private static LanePosition beside(LanePosition from, int lanes) {
    int plain = from.lane() + lanes;
    boolean crossed = from.lane() < 0 ? plain >= 0 : plain <= 0;
    int lane = crossed ? plain + Integer.signum(lanes) : plain;
    return new LanePosition(from.road(), lane, from.s(), from.offset());
  }
}
