package dev.eventchain.roads.reader;

import dev.eventchain.roads.geometry.Profile;
import dev.eventchain.roads.road.RoadSurface;
import dev.eventchain.roads.xml.CheckedElement;
import dev.eventchain.roads.xml.Problems;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** Reader of a road's elevation and lateral profile. */
final class SurfaceReader {

  private final Records records;
  private final Problems problems;

  SurfaceReader(Problems problems) {
    this.problems = problems;
    this.records = new Records(problems);
  }

  RoadSurface read(CheckedElement road) {
    List<CheckedElement> falls = road.children("lateralProfile", "crossfall");
    return new RoadSurface(
        records.profile(road.children("elevationProfile", "elevation"), "s", 0),
        records.profile(road.children("lateralProfile", "superelevation"), "s", 0),
        records.profile(ofSide(falls, "right"), "s", 0),
        records.profile(ofSide(falls, "left"), "s", 0),
        shape(road.children("lateralProfile", "shape")));
  }

  /** Returns the records that are not for the other side only. */
  private static List<CheckedElement> ofSide(List<CheckedElement> falls, String other) {
    return falls.stream()
        .filter(
            fall -> !fall.choice("side", List.of("both", "left", "right"), v -> v).equals(other))
        .toList();
  }

  private List<RoadSurface.CrossSection> shape(List<CheckedElement> elements) {
    records.requireOrder(elements, "s");
    Map<Double, List<CheckedElement>> byPlace = new TreeMap<>();
    for (CheckedElement element : elements) {
      byPlace.computeIfAbsent(element.number("s"), s -> new ArrayList<>()).add(element);
    }
    List<RoadSurface.CrossSection> sections = new ArrayList<>();
    byPlace.forEach((s, pieces) -> sections.add(new RoadSurface.CrossSection(s, height(pieces))));
    return sections;
  }

  private Profile height(List<CheckedElement> elements) {
    List<Profile.Piece> pieces = new ArrayList<>();
    double last = Double.NEGATIVE_INFINITY;
    for (CheckedElement element : elements) {
      double t = element.number("t");
      if (t < last) {
        problems.add(
            RoadRules.ORDER,
            element.at("t"),
            "`t` runs backwards, from " + last + " to " + t + ".",
            "Sort the `shape` elements of one place by `t`.");
      }
      last = t;
      pieces.add(new Profile.Piece(t, RoadReader.cubic(element)));
    }
    return new Profile(pieces);
  }
}
