package dev.eventchain.roads.reader;

import dev.eventchain.roads.geometry.Cubic;
import dev.eventchain.roads.geometry.Profile;
import dev.eventchain.roads.geometry.ReferenceLine;
import dev.eventchain.roads.road.LaneSection;
import dev.eventchain.roads.road.Road;
import dev.eventchain.roads.road.RoadLink;
import dev.eventchain.roads.road.RoadSurface;
import dev.eventchain.roads.xml.CheckedElement;
import dev.eventchain.roads.xml.Problems;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;

/** Reader of roads. */
final class RoadReader {

  private final Problems problems;
  private final PendingLinks links;

  RoadReader(Problems problems, PendingLinks links) {
    this.problems = problems;
    this.links = links;
  }

  /** Reads a road; empty if it has problems, which are reported. */
  Optional<Road> read(String id, CheckedElement element) {
    int before = problems.errors();
    requireSingle(element);
    Road.Facts facts = facts(id, element);
    double length = element.number("length");
    if (length <= 0) {
      problems.add(
          RoadRules.LENGTH, element, "The road is " + length + " m long.", "Remove the road.");
    }
    Optional<ReferenceLine> line = new PlanReader(problems).read(element, length);
    RoadSurface surface = new SurfaceReader(problems).read(element);
    Optional<CheckedElement> lanes = element.requiredChild("lanes");
    Profile offset = lanes.map(child -> offset(child)).orElse(Profile.ZERO);
    List<LaneSection> sections =
        lanes
            .map(child -> new LanesReader(problems, links, id, offset, length).read(child))
            .orElse(List.of());
    if (problems.errors() > before || line.isEmpty()) {
      return Optional.empty();
    }
    Road bare = new Road(facts, line.get(), surface, offset, sections, Road.Furniture.NONE);
    Road.Furniture furniture = furniture(bare, element);
    return problems.errors() > before
        ? Optional.empty()
        : Optional.of(new Road(facts, line.get(), surface, offset, sections, furniture));
  }

  /** Reports parts of which a road has only one, as only the first would be read. */
  private void requireSingle(CheckedElement road) {
    for (String part : List.of("link", "planView", "elevationProfile", "lateralProfile", "lanes")) {
      List<CheckedElement> found = road.children(part);
      if (found.size() > 1) {
        problems.add(
            RoadRules.DUPLICATE,
            found.get(1),
            "The road has a second `" + part + "`.",
            "Remove one of them, or put what is in both into one.");
      }
    }
  }

  private Road.Furniture furniture(Road bare, CheckedElement element) {
    SignalsReader signals = new SignalsReader(problems, bare);
    element.children("signals", "signalReference").stream()
        .map(each -> new PendingLinks.OfSignal(each.string("id"), each.place()))
        .forEach(links.signals::add);
    return new Road.Furniture(
        new ObjectsReader(problems, bare).read(element),
        signals.read(element),
        signals.references(element));
  }

  private Profile offset(CheckedElement lanes) {
    return new Records(problems).profile(lanes.children("laneOffset"), "s", 0);
  }

  private Road.Facts facts(String id, CheckedElement element) {
    Optional<CheckedElement> link = element.child("link");
    return new Road.Facts(
        id,
        element.choice("rule", List.of(Road.Traffic.values()), RoadReader::spelling),
        types(element),
        link.flatMap(child -> link(id, child.child("predecessor"), RoadLink.Contact.START)),
        link.flatMap(child -> link(id, child.child("successor"), RoadLink.Contact.END)),
        userData(element));
  }

  /** Returns values by their codes. Data that is not of this form is for others. */
  private static Map<String, String> userData(CheckedElement road) {
    Map<String, String> data = new HashMap<>();
    for (CheckedElement each : road.children("userData")) {
      Optional<String> value = each.optional("value");
      value.ifPresent(it -> each.optional("code").ifPresent(code -> data.putIfAbsent(code, it)));
    }
    return Map.copyOf(data);
  }

  private static String spelling(Road.Traffic traffic) {
    return traffic == Road.Traffic.RIGHT_HAND ? "RHT" : "LHT";
  }

  /** Reads a link; empty also for one to a place between the ends of a road, which is noted. */
  private Optional<RoadLink> link(
      String id, Optional<CheckedElement> element, RoadLink.Contact end) {
    element
        .filter(child -> child.optional("elementS").isPresent())
        .filter(child -> child.optional("elementDir").isPresent())
        .ifPresent(child -> links.places.add(place(id, child, end)));
    return element
        .filter(child -> child.optional("elementS").isEmpty())
        .map(
            child -> {
              RoadLink link = link(child);
              links.roads.add(new PendingLinks.OfRoad(id, end, link, child.place()));
              return link;
            });
  }

  private static PendingLinks.OfPlace place(
      String id, CheckedElement element, RoadLink.Contact end) {
    return new PendingLinks.OfPlace(
        id,
        end,
        element.string("elementId"),
        element.number("elementS"),
        element.choice("elementDir", List.of(true, false), along -> along ? "+" : "-"),
        element.place());
  }

  private static RoadLink link(CheckedElement element) {
    List<String> types = List.of("road", "junction");
    boolean junction = element.choice("elementType", types, v -> v).equals("junction");
    String id = element.string("elementId");
    if (junction) {
      return new RoadLink(true, id, Optional.empty());
    }
    element.string("contactPoint");
    RoadLink.Contact contact =
        element.choice(
            "contactPoint", List.of(RoadLink.Contact.values()), RoadLink.Contact::spelling);
    return new RoadLink(false, id, Optional.of(contact));
  }

  private List<Road.RoadType> types(CheckedElement road) {
    List<CheckedElement> children = road.children("type");
    new Records(problems).requireOrder(children, "s");
    return children.stream()
        .map(
            child ->
                new Road.RoadType(
                    child.number("s"),
                    child.optional("type").orElse("unknown"),
                    child
                        .child("speed")
                        .map(speed -> new Road.SpeedLimit(child.number("s"), speed(speed)))))
        .toList();
  }

  /** Returns a speed in m/s. */
  static OptionalDouble speed(CheckedElement element) {
    String value = element.string("max").strip();
    if (List.of("", "no limit", "undefined").contains(value.toLowerCase(Locale.ROOT))) {
      return OptionalDouble.empty();
    }
    String unit = element.choice("unit", List.of("m/s", "km/h", "mph"), each -> each);
    double factor = unit.equals("m/s") ? 1 : unit.equals("km/h") ? 1 / 3.6 : 0.44704;
    return OptionalDouble.of(element.number("max") * factor);
  }

  /** Returns a polynomial by its attributes {@code a} to {@code d}. */
  static Cubic cubic(CheckedElement element) {
    return new Cubic(
        element.number("a"), element.number("b"), element.number("c"), element.number("d"));
  }
}
