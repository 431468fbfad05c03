package dev.eventchain.roads.reader;

import dev.eventchain.roads.geometry.PlanPoint;
import dev.eventchain.roads.geometry.Profile;
import dev.eventchain.roads.link.LaneEnd;
import dev.eventchain.roads.link.LaneGraph;
import dev.eventchain.roads.road.Lane;
import dev.eventchain.roads.road.LaneSection;
import dev.eventchain.roads.road.Pose;
import dev.eventchain.roads.road.Road;
import dev.eventchain.roads.road.RoadLink;
import dev.eventchain.roads.road.Signal;
import dev.eventchain.roads.xml.Place;
import dev.eventchain.roads.xml.Problems;
import java.util.Collection;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/** Check of all links of a file, and what they say about lanes. */
final class LaneGraphBuilder {

  /** Distance of linked lanes' middles that may come from widths, in m. */
  private static final double MEETING = 0.5;

  private final Map<String, Road> roads;
  private final Map<String, Junction> junctions;
  private final Problems problems;
  private final LaneGraph graph = new LaneGraph();
  private VirtualLinks virtual;

  LaneGraphBuilder(Map<String, Road> roads, Map<String, Junction> junctions, Problems problems) {
    this.roads = roads;
    this.junctions = junctions;
    this.problems = problems;
  }

  LaneGraph graph(PendingLinks links) {
    links.roads.forEach(this::check);
    virtual = new VirtualLinks(roads, links.places.stream().filter(this::check).toList());
    roads.values().forEach(this::addContinuedLanes);
    links.lanes.forEach(this::add);
    links.junctions.forEach(this::add);
    Set<String> signals =
        roads.values().stream()
            .flatMap(road -> road.signals().stream().map(Signal::id))
            .collect(Collectors.toSet());
    for (PendingLinks.OfSignal reference : links.signals) {
      if (!signals.contains(reference.signal())) {
        report(reference.place(), "signal", reference.signal(), signals);
      }
    }
    return graph;
  }

  private void report(Place place, String kind, String id, Collection<String> known) {
    problems.add(
        RoadRules.LINK,
        place.location(),
        "There is no " + kind + " `" + id + "`.",
        listed(known) + "Correct the link, or remove it.");
  }

  /** Returns a few of the known ids. The nearest one would say nothing: most are numbers. */
  private static String listed(Collection<String> known) {
    String ids = known.stream().sorted().limit(12).collect(Collectors.joining("`, `"));
    return known.isEmpty()
        ? ""
        : "Known are `" + ids + "`" + (known.size() > 12 ? ", .... " : ". ");
  }

  private void check(PendingLinks.OfRoad each) {
    RoadLink link = each.link();
    if (link.junction() && !junctions.containsKey(link.id())) {
      report(each.place(), "junction", link.id(), junctions.keySet());
    } else if (!link.junction() && !roads.containsKey(link.id())) {
      report(each.place(), "road", link.id(), roads.keySet());
    }
  }

  /** Reports a link to a place that is not there; returns whether it is. */
  private boolean check(PendingLinks.OfPlace each) {
    Road main = roads.get(each.main());
    if (main == null) {
      report(each.place(), "road", each.main(), roads.keySet());
    } else if (!(each.s() >= 0 && each.s() <= main.length() + Profile.ROUNDING)) {
      problems.add(
          RoadRules.LINK,
          each.place().location(),
          "Road `" + each.main() + "` has no place s = " + each.s() + ".",
          "It is " + main.length() + " m long. Correct `elementS`, or remove the link.");
      return false;
    }
    return main != null;
  }

  /** Links lanes of which a section of the other side begins beside them. */
  private void addContinuedLanes(Road road) {
    for (int i = 1; i < road.sections().size(); i++) {
      LaneSection before = road.sections().get(i - 1);
      for (Lane lane : road.sections().get(i).lanes()) {
        if (before.lane(lane.id()).filter(other -> other == lane).isPresent()) {
          graph.add(
              new LaneEnd(road, i - 1, lane.id(), true), new LaneEnd(road, i, lane.id(), false));
        }
      }
    }
  }

  private void add(PendingLinks.OfLane each) {
    Road road = roads.get(each.road());
    int section = virtual.section(each.road(), each.section(), each.forward());
    LaneEnd from = new LaneEnd(road, section, each.lane(), each.forward());
    int next = section + (each.forward() ? 1 : -1);
    if (next >= 0 && next < road.sections().size()) {
      link(from, new LaneEnd(road, next, each.target(), !each.forward()), each.place());
      return;
    }
    Optional<RoadLink> link = each.forward() ? road.successor() : road.predecessor();
    // Lanes that lead into a junction are linked by its connections.
    link.filter(found -> !found.junction() && roads.containsKey(found.id()))
        .ifPresent(
            found ->
                link(
                    from,
                    end(roads.get(found.id()), found.contact().orElseThrow(), each.target()),
                    each.place()));
    if (link.isEmpty()) {
      RoadLink.Contact end = each.forward() ? RoadLink.Contact.END : RoadLink.Contact.START;
      virtual.end(each.road(), end, each.target()).ifPresent(to -> link(from, to, each.place()));
    }
  }

  private static LaneEnd end(Road road, RoadLink.Contact contact, int lane) {
    boolean atEnd = contact == RoadLink.Contact.END;
    return new LaneEnd(road, atEnd ? road.sections().size() - 1 : 0, lane, atEnd);
  }

  private void link(LaneEnd from, LaneEnd to, Place place) {
    boolean fromExists = require(from, place);
    boolean toExists = require(to, place);
    if (fromExists && toExists) {
      graph.add(from, to);
      requireMeeting(from, to, place);
    }
  }

  private void requireMeeting(LaneEnd from, LaneEnd to, Place place) {
    Pose end = from.pose();
    Pose start = to.pose();
    double apart = StrictMath.hypot(start.x() - end.x(), start.y() - end.y());
    if (apart > MEETING) {
      problems.add(
          RoadRules.LINK_APART,
          place.location(),
          "The linked lanes "
              + from
              + " and "
              + to
              + " are "
              + Math.round(apart * 100) / 100.0
              + " m apart.",
          "A path along them jumps there. Correct the link, or the roads.");
    }
  }

  private boolean require(LaneEnd end, Place place) {
    boolean exists = end.lane() != 0 && end.laneSection().lane(end.lane()).isPresent();
    if (!exists) {
      String lanes =
          end.laneSection().lanes().stream()
              .map(Lane::id)
              .filter(id -> id != 0)
              .map(String::valueOf)
              .collect(Collectors.joining(", "));
      problems.add(
          RoadRules.LINK,
          place.location(),
          "Road `" + end.road().id() + "` has no lane " + end.lane() + " at s = " + end.s() + ".",
          "Its lanes there are " + lanes + ". Correct the link, or remove it.");
    }
    return exists;
  }

  private void add(PendingLinks.OfJunction each) {
    Junction.Connection connection = each.connection();
    Road incoming = roads.get(connection.incoming());
    Road road = roads.get(connection.road());
    if (each.kind() == Junction.Kind.VIRTUAL) {
      addVirtual(each, road);
    } else if (incoming == null) {
      report(each.place(), "road", connection.incoming(), roads.keySet());
    } else if (road == null) {
      report(each.place(), "road", connection.road(), roads.keySet());
    } else {
      RoadLink.Contact contact = contact(incoming, each.junction(), road, connection.contact());
      for (Junction.LaneLink lane : connection.lanes()) {
        link(
            end(incoming, contact, lane.from()),
            end(road, connection.contact(), lane.to()),
            each.place());
      }
    }
  }

  /** Links the lanes of a road that leaves another one, of which its own end says where. */
  private void addVirtual(PendingLinks.OfJunction each, Road road) {
    Junction.Connection connection = each.connection();
    for (Junction.LaneLink lane : connection.lanes()) {
      virtual
          .end(connection.road(), connection.contact(), lane.from())
          .ifPresent(from -> link(from, end(road, connection.contact(), lane.to()), each.place()));
    }
  }

  /** Returns the end of an incoming road that is at a junction; the nearer one if both may be. */
  private static RoadLink.Contact contact(
      Road incoming, String junction, Road road, RoadLink.Contact of) {
    boolean start = leadsTo(incoming.predecessor(), junction);
    boolean end = leadsTo(incoming.successor(), junction);
    if (start != end) {
      return start ? RoadLink.Contact.START : RoadLink.Contact.END;
    }
    PlanPoint to = road.plan(of == RoadLink.Contact.START ? 0 : road.length());
    return distance(incoming.plan(0), to) < distance(incoming.plan(incoming.length()), to)
        ? RoadLink.Contact.START
        : RoadLink.Contact.END;
  }

  private static boolean leadsTo(Optional<RoadLink> link, String junction) {
    return link.filter(found -> found.junction() && found.id().equals(junction)).isPresent();
  }

  private static double distance(PlanPoint first, PlanPoint second) {
    return StrictMath.hypot(first.x() - second.x(), first.y() - second.y());
  }
}
