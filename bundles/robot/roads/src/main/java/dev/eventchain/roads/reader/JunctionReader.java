package dev.eventchain.roads.reader;

import dev.eventchain.roads.road.RoadLink;
import dev.eventchain.roads.xml.CheckedElement;
import java.util.ArrayList;
import java.util.List;

/** Reader of junctions. */
final class JunctionReader {

  private JunctionReader() {}

  static Junction read(String id, CheckedElement element, PendingLinks links) {
    Junction.Kind kind =
        element.choice("type", List.of(Junction.Kind.values()), Junction.Kind::spelling);
    boolean meetsEnds = kind == Junction.Kind.COMMON || kind == Junction.Kind.DIRECT;
    List<Junction.Connection> connections = new ArrayList<>();
    for (CheckedElement child : element.children("connection")) {
      // A virtual connection leaves its road between the ends, and may lack a road.
      boolean atEnds = meetsEnds && child.optional("type").filter("virtual"::equals).isEmpty();
      String road = kind == Junction.Kind.DIRECT ? "linkedRoad" : "connectingRoad";
      Junction.Connection connection = connection(child, road, atEnds);
      connections.add(connection);
      if (atEnds || kind == Junction.Kind.VIRTUAL) {
        links.junctions.add(new PendingLinks.OfJunction(id, kind, connection, child.place()));
      }
    }
    return new Junction(id, kind, connections);
  }

  private static Junction.Connection connection(
      CheckedElement element, String road, boolean named) {
    return new Junction.Connection(
        element.string("id"),
        named ? element.string("incomingRoad") : element.optional("incomingRoad").orElse(""),
        named ? element.string(road) : element.optional(road).orElse(""),
        element.choice(
            "contactPoint", List.of(RoadLink.Contact.values()), RoadLink.Contact::spelling),
        element.children("laneLink").stream()
            .map(link -> new Junction.LaneLink(link.integer("from"), link.integer("to")))
            .toList());
  }
}
