package dev.eventchain.roads;

import dev.eventchain.roads.xml.XmlElement;
import java.util.ArrayList;
import java.util.List;

/** Reader of junctions. */
final class JunctionReader {

  private JunctionReader() {}

  static Junction read(String id, XmlElement element, PendingLinks links) {
    Junction.Kind kind =
        element.choice("type", List.of(Junction.Kind.values()), Junction.Kind::spelling);
    List<Junction.Connection> connections = new ArrayList<>();
    for (XmlElement child : element.children("connection")) {
      Junction.Connection connection = connection(child, kind);
      connections.add(connection);
      if (kind == Junction.Kind.COMMON || kind == Junction.Kind.DIRECT) {
        links.junctions.add(new PendingLinks.OfJunction(id, connection, child.place()));
      }
    }
    return new Junction(id, element.optional("name").orElse(""), kind, connections);
  }

  private static Junction.Connection connection(XmlElement element, Junction.Kind kind) {
    String road = kind == Junction.Kind.DIRECT ? "linkedRoad" : "connectingRoad";
    // Up to 1.4, there is nothing but connecting roads; a virtual connection may lack a road.
    boolean named = kind == Junction.Kind.COMMON || kind == Junction.Kind.DIRECT;
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
