package dev.eventchain.roads;

import dev.eventchain.roads.link.LaneEnd;
import dev.eventchain.roads.road.Lane;
import dev.eventchain.roads.road.LaneSection;
import dev.eventchain.roads.road.Road;
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

  /**
   * A road in a direction.
   *
   * @param entered s from which on it is driven
   */
  private record Way(Road road, boolean alongS, double entered) {}

  /**
   * A way that has been reached.
   *
   * @param distance to where it is entered, or to the target if it is the last one
   * @param before null for the first one
   * @param left s where the way before was left
   */
  private record Reached(Way way, double distance, Reached before, double left, boolean last) {}

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
        Reached start = new Reached(way, 0, null, 0, false);
        arrive(start, to, queue);
        expand(start, lane, queue);
      }
    }
    Map<Way, Double> done = new HashMap<>();
    while (!queue.isEmpty()) {
      Reached next = queue.remove();
      if (next.last) {
        return Optional.of(legs(next, to));
      }
      if (done.putIfAbsent(next.way, next.distance) == null) {
        arrive(next, to, queue);
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
        ways.add(new Way(road, alongS, position.s()));
      }
    }
    return ways;
  }

  /** Queues the target if it is on a way, behind where the way is entered. */
  private void arrive(Reached at, LanePosition to, PriorityQueue<Reached> queue) {
    Way way = at.way;
    boolean behind = way.alongS ? to.s() >= way.entered : to.s() <= way.entered;
    boolean there =
        behind
            && ways(to).stream()
                .anyMatch(each -> each.road == way.road && each.alongS == way.alongS);
    if (there) {
      double distance = at.distance + Math.abs(to.s() - way.entered);
      queue.add(new Reached(way, distance, at, to.s(), true));
    }
  }

  /** Queues the ways that lanes lead to, at the end of the road and where others leave it. */
  private void expand(Reached at, Lane kind, PriorityQueue<Reached> queue) {
    Way way = at.way;
    List<LaneSection> sections = way.road.sections();
    for (int section = 0; section < sections.size(); section++) {
      double left = way.alongS ? sections.get(section).end() : sections.get(section).start();
      boolean ahead = way.alongS ? left >= way.entered : left <= way.entered;
      if (ahead) {
        for (Way next : nexts(way, section, kind)) {
          double distance = at.distance + Math.abs(left - way.entered);
          queue.add(new Reached(next, distance, at, left, false));
        }
      }
    }
  }

  /** Returns the ways that lanes of a section's end lead to, other roads that is. */
  private Set<Way> nexts(Way way, int section, Lane kind) {
    Set<Way> nexts = new LinkedHashSet<>();
    for (Lane lane : way.road.sections().get(section).lanes()) {
      boolean usable =
          kind.isDrivable()
              ? lane.isDrivable() && way.road.leads(lane, way.alongS)
              : lane.type().equals(kind.type());
      if (lane.id() != 0 && usable) {
        LaneEnd exit = new LaneEnd(way.road, section, lane.id(), way.alongS);
        network.graph().from(exit).stream()
            .filter(entry -> !exit.goesOnAt(entry))
            .map(entry -> new Way(entry.road(), !entry.atEnd(), entry.s()))
            .forEach(nexts::add);
      }
    }
    return nexts;
  }

  private static List<Route.Leg> legs(Reached target, LanePosition to) {
    List<Route.Leg> legs = new ArrayList<>();
    double end = to.s();
    for (Reached at = target.before; at != null; at = at.before) {
      legs.add(new Route.Leg(at.way.road.id(), at.way.alongS, at.way.entered, end));
      end = at.left;
    }
    Collections.reverse(legs);
    return legs;
  }
}
