package dev.eventchain.roads.reader;

import dev.eventchain.roads.geometry.Profile;
import dev.eventchain.roads.road.Lane;
import dev.eventchain.roads.road.LaneSection;
import dev.eventchain.roads.xml.CheckedElement;
import dev.eventchain.roads.xml.Problems;
import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.stream.Stream;

/**
 * Reader of a road's lane sections. A section may be about one side only; so the sides are read
 * apart, and a section of the result begins wherever one of a side does.
 */
final class LanesReader {

  private final Problems problems;
  private final PendingLinks links;
  private final String road;
  private final Profile offset;
  private final double length;
  private final LaneReader laneReader;

  /** The lanes of one side, from inside to outside, with the elements they were read from. */
  private record Side(double start, List<Lane> lanes, List<CheckedElement> elements) {}

  LanesReader(Problems problems, PendingLinks links, String road, Profile offset, double length) {
    this.problems = problems;
    this.links = links;
    this.road = road;
    this.offset = offset;
    this.length = length;
    this.laneReader = new LaneReader(problems);
  }

  /** Reads the sections; with problems, which are reported, the result is of no use. */
  List<LaneSection> read(CheckedElement lanes) {
    int before = problems.errors();
    List<CheckedElement> elements = lanes.children("laneSection");
    if (elements.isEmpty()) {
      lanes.requiredChild("laneSection");
    }
    new Records(problems).requireOrder(elements, "s");
    List<Side> left = new ArrayList<>();
    List<Side> right = new ArrayList<>();
    List<Side> centre = new ArrayList<>();
    for (CheckedElement element : elements) {
      section(element, left, right, centre);
    }
    if (problems.errors() > before) {
      return List.of();
    }
    requireStart(elements.get(0), left, right);
    List<LaneSection> sections = merged(left, right, centre);
    requireLengths(elements, sections);
    left.forEach(side -> noteLinks(side, left, sections));
    right.forEach(side -> noteLinks(side, right, sections));
    return sections;
  }

  private void section(
      CheckedElement element, List<Side> left, List<Side> right, List<Side> centre) {
    double start = element.number("s");
    boolean single = element.choice("singleSide", List.of("false", "true"), v -> v).equals("true");
    boolean hasLeft = element.child("left").isPresent();
    if (!single || hasLeft) {
      left.add(side(element, "left", start));
    }
    if (!single || !hasLeft) {
      right.add(side(element, "right", start));
    }
    element
        .requiredChild("center")
        .flatMap(child -> child.requiredChild("lane"))
        .ifPresent(
            lane ->
                centre.add(
                    new Side(start, List.of(laneReader.read(lane, 0, start)), List.of(lane))));
  }

  private Side side(CheckedElement section, String name, double start) {
    int sign = name.equals("left") ? 1 : -1;
    List<CheckedElement> elements = new ArrayList<>(section.children(name, "lane"));
    elements.sort((first, second) -> Integer.compare(distance(first), distance(second)));
    List<Lane> lanes = new ArrayList<>();
    for (CheckedElement element : elements) {
      int expected = sign * (lanes.size() + 1);
      int before = problems.errors();
      int id = element.integer("id");
      if (id != expected && problems.errors() == before) {
        problems.add(
            RoadRules.LANE_ID,
            element.at("id"),
            "The lane is " + id + " where lane " + expected + " is due.",
            "Lanes count from 1 on the left and from -1 down on the right, without holes.");
      }
      lanes.add(laneReader.read(element, expected, start));
    }
    return new Side(start, lanes, elements);
  }

  private static int distance(CheckedElement lane) {
    return lane.isNumber("id") ? Math.abs((int) lane.number("id")) : 0;
  }

  private void requireStart(CheckedElement first, List<Side> left, List<Side> right) {
    boolean missing =
        Stream.of(left, right)
            .anyMatch(side -> side.isEmpty() || side.get(0).start > Profile.ROUNDING);
    if (missing) {
      problems.add(
          RoadRules.GAP,
          first,
          "There is no lane section at the start of the road, or of one side of it.",
          "The first lane section begins at 0.");
    }
  }

  private void requireLengths(List<CheckedElement> elements, List<LaneSection> sections) {
    for (LaneSection section : sections) {
      if (section.end() <= section.start()) {
        CheckedElement element =
            elements.stream()
                .filter(each -> each.number("s") == section.start())
                .findFirst()
                .orElseThrow();
        problems.add(
            RoadRules.LENGTH,
            element,
            "The lane section begins at s = " + section.start() + ", where the road ends.",
            "Remove the section, or correct its `s`.");
      }
    }
  }

  private List<LaneSection> merged(List<Side> left, List<Side> right, List<Side> centre) {
    SortedSet<Double> starts = new TreeSet<>();
    left.forEach(side -> starts.add(side.start));
    right.forEach(side -> starts.add(side.start));
    List<Double> all = List.copyOf(starts);
    List<LaneSection> sections = new ArrayList<>();
    for (int i = 0; i < all.size(); i++) {
      double start = all.get(i);
      double end = i + 1 < all.size() ? all.get(i + 1) : length;
      sections.add(
          new LaneSection(
              start,
              end,
              offset,
              at(left, start).lanes,
              at(right, start).lanes,
              at(centre, start).lanes.get(0)));
    }
    return sections;
  }

  private static Side at(List<Side> sides, double start) {
    Side found = sides.isEmpty() ? new Side(0, List.of(), List.of()) : sides.get(0);
    for (Side side : sides) {
      found = side.start <= start ? side : found;
    }
    return found;
  }

  private void noteLinks(Side side, List<Side> all, List<LaneSection> sections) {
    int next = all.indexOf(side) + 1;
    double end = next < all.size() ? all.get(next).start : length;
    int first = 0;
    int last = 0;
    for (int i = 0; i < sections.size(); i++) {
      first = sections.get(i).start() <= side.start ? i : first;
      last = sections.get(i).start() < end ? i : last;
    }
    for (int i = 0; i < side.elements.size(); i++) {
      CheckedElement element = side.elements.get(i);
      laneReader.requireWidth(element, side.lanes.get(i), side.start, end);
      note(element, side.lanes.get(i).id(), first, "predecessor");
      note(element, side.lanes.get(i).id(), last, "successor");
    }
  }

  private void note(CheckedElement element, int lane, int section, String direction) {
    for (CheckedElement link : element.children("link", direction)) {
      links.lanes.add(
          new PendingLinks.OfLane(
              road,
              section,
              lane,
              direction.equals("successor"),
              link.integer("id"),
              link.place()));
    }
  }
}
