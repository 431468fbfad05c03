package dev.eventchain.roads.reader;

import dev.eventchain.roads.road.RoadLink;
import dev.eventchain.roads.xml.Place;
import java.util.ArrayList;
import java.util.List;

/** The links of a file with their places, until all that they refer to is read. */
final class PendingLinks {

  /** A link of a road's end. */
  record OfRoad(String road, RoadLink.Contact end, RoadLink link, Place place) {}

  /**
   * A link of a road's end to a place between the ends of another road.
   *
   * @param main the id of the other road
   * @param s the place on it
   * @param alongS whether the other road is driven along its s before it is left, or after it is
   *     joined
   */
  record OfPlace(
      String road, RoadLink.Contact end, String main, double s, boolean alongS, Place place) {}

  /**
   * A link of a lane.
   *
   * @param section the index of the lane section
   * @param forward whether it leads along s
   */
  record OfLane(String road, int section, int lane, boolean forward, int target, Place place) {}

  /** A connection of a junction. */
  record OfJunction(
      String junction, Junction.Kind kind, Junction.Connection connection, Place place) {}

  /** A reference to a signal. */
  record OfSignal(String signal, Place place) {}

  final List<OfRoad> roads = new ArrayList<>();
  final List<OfPlace> places = new ArrayList<>();
  final List<OfLane> lanes = new ArrayList<>();
  final List<OfJunction> junctions = new ArrayList<>();
  final List<OfSignal> signals = new ArrayList<>();
}
