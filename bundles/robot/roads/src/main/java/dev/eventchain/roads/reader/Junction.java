package dev.eventchain.roads.reader;

import dev.eventchain.roads.road.RoadLink;
import java.util.List;

/**
 * A junction.
 *
 * @param id the id
 * @param kind what its connections are
 * @param connections in the order of the file
 */
record Junction(String id, Kind kind, List<Connection> connections) {

  /** Kind of a junction by its connections. */
  enum Kind {
    /** Roads that lead through the junction. */
    COMMON("default"),
    /** Roads that meet directly, as at an exit of a motorway. */
    DIRECT("direct"),
    /** Roads that leave another one between its ends, or join it there. */
    VIRTUAL("virtual"),
    /** A crossing of roads without connections. */
    CROSSING("crossing");

    private final String spelling;

    Kind(String spelling) {
      this.spelling = spelling;
    }

    /** Returns its name in OpenDRIVE. */
    String spelling() {
      return spelling;
    }
  }

  /**
   * A way through a junction.
   *
   * @param incoming the id of the road that leads to the junction
   * @param road the id of the road that leads through it, or of the linked road of a direct one
   * @param contact the end of that road at which the way begins
   * @param lanes the lanes that are linked; empty if the file has none
   */
  record Connection(
      String id, String incoming, String road, RoadLink.Contact contact, List<LaneLink> lanes) {

    /** Copies the links. */
    public Connection {
      lanes = List.copyOf(lanes);
    }
  }

  /**
   * A link between lanes.
   *
   * @param from the lane of the incoming road
   * @param to the lane of the other road
   */
  record LaneLink(int from, int to) {}

  /** Copies the connections. */
  Junction {
    connections = List.copyOf(connections);
  }
}
