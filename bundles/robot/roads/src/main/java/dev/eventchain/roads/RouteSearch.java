package dev.eventchain.roads;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.PriorityQueue;
import java.util.Set;

/**
 * Search for shortest routes by Dijkstra's algorithm, on roads with a direction. Vehicles may
 * change lanes anywhere on a road; who begins on another kind of lane stays on that kind.
 */
final class RouteSearch {

  private final RoadNetwork network;

  /** A road in a direction. */
  private record Way(Road road, boolean alongS) {

    double start() {
      return alongS ? 0 : road.length();
    }

    double end() {
      return alongS ? road.length() : 0;
    }
  }

  /**
   * A way that has been reached.
   *
   * @param distance to where it begins, or to the target if it is the last one
   * @param before null for the first one
   */
  private record Reached(Way way, double distance, Reached before, boolean last) {}

  RouteSearch(RoadNetwork network) {
    this.network = network;
  }

  Optional<Route> route(List<LanePosition> waypoints) {
    List<Route.Leg> legs = new ArrayList<>();
    for (int i = 1; i < waypoints.size(); i++) {
      Optional<Boolean> sense =
          legs.isEmpty() ? Optional.empty() : Optional.of(legs.get(legs.size() - 1).alongS());
      Optional<List<Route.Leg>> part = between(waypoints.get(i - 1), waypoints.get(i), sense);
      if (part.isEmpty()) {
        return Optional.empty();
      }
      append(legs, part.get());
    }
    return legs.isEmpty() ? Optional.empty() : Optional.of(new Route(legs));
  }

  /** Appends a part, whose first leg goes on where the last one ended. */
  private static void append(List<Route.Leg> legs, List<Route.Leg> part) {
    if (legs.isEmpty()) {
      legs.addAll(part);
      return;
    }
    Route.Leg last = legs.remove(legs.size() - 1);
    Route.Leg first = part.get(0);
    legs.add(new Route.Leg(last.road(), last.alongS(), last.from(), first.to()));
    legs.addAll(part.subList(1, part.size()));
  }

  private Optional<List<Route.Leg>> between(
      LanePosition from, LanePosition to, Optional<Boolean> sense) {
    Lane lane = lane(from);
    PriorityQueue<Reached> queue =
        new PriorityQueue<>(Comparator.comparingDouble(Reached::distance));
    for (Way way : ways(from)) {
      if (sense.isEmpty() || sense.get() == way.alongS) {
        Reached start = new Reached(way, -Math.abs(from.s() - way.start()), null, false);
        arrive(start, from.s(), to, queue);
        expand(start, lane, queue);
      }
    }
    Map<Way, Double> done = new HashMap<>();
    while (!queue.isEmpty()) {
      Reached next = queue.remove();
      if (next.last) {
        return Optional.of(legs(next, from, to));
      }
      if (done.putIfAbsent(next.way, next.distance) == null) {
        arrive(next, next.way.start(), to, queue);
        expand(next, lane, queue);
      }
    }
    return Optional.empty();
  }

  private Lane lane(LanePosition position) {
    return network
        .road(position.road())
        .orElseThrow()
        .lane(position.s(), position.lane())
        .orElseThrow();
  }

  /** Returns the directions in which a position may be passed. */
  private List<Way> ways(LanePosition position) {
    Road road = network.road(position.road()).orElseThrow();
    Lane lane = lane(position);
    List<Way> ways = new ArrayList<>();
    for (boolean alongS : new boolean[] {true, false}) {
      if (!lane.isDrivable() || road.leads(lane, alongS)) {
        ways.add(new Way(road, alongS));
      }
    }
    return ways;
  }

  /** Queues the target if it is on a way, behind where the way is entered. */
  private void arrive(Reached at, double entered, LanePosition to, PriorityQueue<Reached> queue) {
    boolean behind = at.way.alongS ? to.s() >= entered : to.s() <= entered;
    if (behind && ways(to).contains(at.way)) {
      double distance = at.distance + Math.abs(to.s() - at.way.start());
      queue.add(new Reached(at.way, distance, at, true));
    }
  }

  private void expand(Reached at, Lane lane, PriorityQueue<Reached> queue) {
    for (Way next : nexts(at.way, lane)) {
      queue.add(new Reached(next, at.distance + at.way.road.length(), at, false));
    }
  }

  /** Returns the ways that lanes of a road's end lead to. */
  private Set<Way> nexts(Way way, Lane kind) {
    Set<Way> nexts = new LinkedHashSet<>();
    int section = way.alongS ? way.road.sections().size() - 1 : 0;
    for (Lane lane : way.road.sections().get(section).lanes()) {
      boolean usable =
          kind.isDrivable()
              ? lane.isDrivable() && way.road.leads(lane, way.alongS)
              : lane.type().equals(kind.type());
      if (lane.id() != 0 && usable) {
        network.graph().from(new LaneEnd(way.road, section, lane.id(), way.alongS)).stream()
            .map(entry -> new Way(entry.road(), !entry.atEnd()))
            .forEach(nexts::add);
      }
    }
    return nexts;
  }

  private static List<Route.Leg> legs(Reached target, LanePosition from, LanePosition to) {
    List<Way> ways = new ArrayList<>();
    for (Reached at = target.before; at != null; at = at.before) {
      ways.add(at.way);
    }
    Collections.reverse(ways);
    List<Route.Leg> legs = new ArrayList<>();
    for (int i = 0; i < ways.size(); i++) {
      Way way = ways.get(i);
      double start = i == 0 ? from.s() : way.start();
      double end = i == ways.size() - 1 ? to.s() : way.end();
      legs.add(new Route.Leg(way.road.id(), way.alongS, start, end));
    }
    return legs;
  }
}
