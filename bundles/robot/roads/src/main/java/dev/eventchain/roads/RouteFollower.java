package dev.eventchain.roads;

import dev.eventchain.roads.geometry.Profile;
import dev.eventchain.roads.link.LaneEnd;
import dev.eventchain.roads.link.LaneWalk;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/** Choice of the lanes that lead along a route. */
final class RouteFollower {

  /** Length of a change of lanes, where there is room, in m. */
  private static final double CHANGE = 60;

  private final RoadNetwork network;
  private final Route route;
  private int leg;

  RouteFollower(RoadNetwork network, Route route) {
    this.network = network;
    this.route = route;
  }

  /**
   * Returns a track that leaves its section where the route goes on: the same one, or one with a
   * change to the nearest lane that leads on. The same one if no lane does.
   *
   * @param from s from which on it may change
   */
  LaneTrack leading(LaneTrack track, double from) {
    LaneEnd exit = track.exit();
    if (isLast() || onRoute(exit).isPresent()) {
      return track;
    }
    double room = exit.s() - from;
    double length = Math.min(Math.abs(room), CHANGE);
    return exit.laneSection().lanes().stream()
        .filter(lane -> lane.id() != 0 && Math.signum(lane.id()) == Math.signum(exit.lane()))
        .map(lane -> new LaneEnd(exit.road(), exit.section(), lane.id(), exit.atEnd()))
        .filter(end -> onRoute(end).isPresent() && length > 0)
        .min(Comparator.comparingInt(end -> Math.abs(end.lane() - exit.lane())))
        .map(end -> new LaneTrack.Change(end.lane(), from, from + Math.signum(room) * length))
        .map(change -> new LaneTrack(track.exit().other(), Optional.of(change)))
        .orElse(track);
  }

  private boolean isLast() {
    return leg >= route.legs().size() - 1;
  }

  /** Returns the entry behind an exit that is on the route; the straightest behind its end. */
  Optional<LaneEnd> next(LaneEnd exit) {
    Optional<LaneEnd> next = onRoute(exit);
    if (next.isPresent() && !exit.goesOnAt(next.get())) {
      leg++;
    }
    return next;
  }

  private Optional<LaneEnd> onRoute(LaneEnd exit) {
    List<LaneEnd> entries = network.graph().from(exit);
    if (isLast()) {
      return LaneWalk.straightest(exit, entries);
    }
    boolean leaves = Math.abs(exit.s() - route.legs().get(leg).to()) < Profile.ROUNDING;
    if (!leaves) {
      return entries.stream().filter(exit::goesOnAt).findFirst();
    }
    Route.Leg next = route.legs().get(leg + 1);
    return entries.stream()
        .filter(entry -> entry.road().id().equals(next.road()) && entry.atEnd() != next.alongS())
        .findFirst();
  }
}
