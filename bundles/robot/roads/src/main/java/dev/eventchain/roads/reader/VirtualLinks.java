package dev.eventchain.roads.reader;

import dev.eventchain.roads.geometry.Profile;
import dev.eventchain.roads.link.LaneEnd;
import dev.eventchain.roads.road.LaneSection;
import dev.eventchain.roads.road.Road;
import dev.eventchain.roads.road.RoadLink;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * The links of roads' ends to places between the ends of other roads, as in virtual junctions. A
 * road is divided into more lane sections where another one leaves or joins it, so that lanes have
 * ends there which can be linked.
 */
final class VirtualLinks {

  private final Map<String, Road> roads;

  /** The roads as their lane sections were read, of those that were divided. */
  private final Map<String, Road> whole = new LinkedHashMap<>();

  private final List<PendingLinks.OfPlace> links = new ArrayList<>();

  /**
   * Divides roads.
   *
   * @param roads by their ids; divided ones replace those that they were made of
   * @param links of roads that are there, to places that are on their roads
   */
  VirtualLinks(Map<String, Road> roads, List<PendingLinks.OfPlace> links) {
    this.roads = roads;
    for (PendingLinks.OfPlace each : links) {
      Road road = roads.get(each.main());
      boolean between = each.s() > Profile.ROUNDING && each.s() < road.length() - Profile.ROUNDING;
      if (between) {
        whole.putIfAbsent(each.main(), road);
        roads.put(each.main(), road.divided(each.s()));
        this.links.add(each);
      }
    }
  }

  /** Returns the index that a lane section of a file has, or the end of it towards one side. */
  int section(String road, int section, boolean atEnd) {
    Road before = whole.get(road);
    if (before == null) {
      return section;
    }
    Road divided = roads.get(road);
    LaneSection read = before.sections().get(section);
    if (!atEnd) {
      return divided.sectionIndex(read.start());
    }
    int index = section;
    while (divided.sections().get(index).end() < read.end()) {
      index++;
    }
    return index;
  }

  /** Returns the end of a lane that an end of a road is linked to between the ends of another. */
  Optional<LaneEnd> end(String road, RoadLink.Contact contact, int lane) {
    return links.stream()
        .filter(each -> each.road().equals(road) && each.end() == contact)
        .findFirst()
        .flatMap(each -> end(each, lane));
  }

  /**
   * Vehicles that leave a road come along it, and those that join it go on along it, in the
   * direction.
   */
  private Optional<LaneEnd> end(PendingLinks.OfPlace link, int lane) {
    boolean atEnd = link.alongS() == (link.end() == RoadLink.Contact.START);
    Road road = roads.get(link.main());
    OptionalInt section = OptionalInt.empty();
    for (int i = 0; i < road.sections().size(); i++) {
      LaneSection each = road.sections().get(i);
      if (Math.abs((atEnd ? each.end() : each.start()) - link.s()) < Profile.ROUNDING) {
        section = OptionalInt.of(i);
      }
    }
    return section.isPresent()
        ? Optional.of(new LaneEnd(road, section.getAsInt(), lane, atEnd))
        : Optional.empty();
  }
}
