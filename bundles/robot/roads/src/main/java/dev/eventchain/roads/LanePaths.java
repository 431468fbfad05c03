package dev.eventchain.roads;

import dev.eventchain.roads.link.LaneEnd;
import dev.eventchain.roads.link.LaneWalk;
import dev.eventchain.roads.road.Road;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Maker of paths along lanes. */
final class LanePaths {

  private final RoadNetwork network;
  private final LaneWalk walk;

  LanePaths(RoadNetwork network) {
    this.network = network;
    this.walk = new LaneWalk(network.graph());
  }

  /** Returns a path through a position that exists. */
  LanePath path(
      LanePosition position, boolean alongS, double behind, double ahead, Optional<Route> route) {
    Road road = network.road(position.road()).orElseThrow();
    int section = road.sectionIndex(position.s());
    LaneEnd entry = new LaneEnd(road, section, position.lane(), !alongS);
    LaneTrack own = new LaneTrack(entry, Optional.empty());
    double before = own.lengthTo(position.s());
    List<LaneTrack> tracks = behind(entry, behind - before);
    double origin = before + tracks.stream().mapToDouble(LaneTrack::length).sum();
    tracks.add(own);
    ahead(tracks, position.s(), ahead - (own.length() - before), route.map(this::follower));
    return new LanePath(new PathCurve(tracks), origin);
  }

  private RouteFollower follower(Route route) {
    return new RouteFollower(network, route);
  }

  /** Returns the tracks that lead to an entry, in the order of the path. */
  private List<LaneTrack> behind(LaneEnd entry, double distance) {
    List<LaneTrack> tracks = new ArrayList<>();
    double left = distance;
    Optional<LaneEnd> end = walk.straightest(entry);
    while (left > 0 && end.isPresent() && tracks.size() < LaneWalk.MOST_SECTIONS) {
      LaneTrack track = new LaneTrack(end.get().other(), Optional.empty());
      tracks.add(0, track);
      left -= track.length();
      end = walk.straightest(end.get().other());
    }
    return tracks;
  }

  /**
   * Appends the tracks that follow the last one.
   *
   * @param s of the last track's place from which on it may change lanes
   */
  private void ahead(
      List<LaneTrack> tracks, double s, double distance, Optional<RouteFollower> follower) {
    double left = distance;
    double from = s;
    int most = tracks.size() + LaneWalk.MOST_SECTIONS;
    while (left > 0 && tracks.size() < most) {
      LaneTrack last = tracks.remove(tracks.size() - 1);
      double here = from;
      LaneTrack leading = follower.map(each -> each.leading(last, here)).orElse(last);
      tracks.add(leading);
      Optional<LaneEnd> next =
          follower.isPresent()
              ? follower.get().next(leading.exit())
              : walk.straightest(leading.exit());
      if (next.isEmpty()) {
        return;
      }
      LaneTrack track = new LaneTrack(next.get(), Optional.empty());
      tracks.add(track);
      left -= track.length();
      from = next.get().s();
    }
  }
}
