package dev.eventchain.roads.reader;

import dev.eventchain.roads.geometry.Cubic;
import dev.eventchain.roads.geometry.Profile;
import dev.eventchain.roads.road.Lane;
import dev.eventchain.roads.road.Road;
import dev.eventchain.roads.road.RoadMark;
import dev.eventchain.roads.xml.CheckedElement;
import dev.eventchain.roads.xml.Problems;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** Reader of lanes. */
final class LaneReader {

  /** Width below 0 that comes from fitted polynomials and is not worth a word, in m. */
  private static final double NEARLY_NOTHING = 0.01;

  private final Problems problems;
  private final Records records;

  LaneReader(Problems problems) {
    this.problems = problems;
    this.records = new Records(problems);
  }

  /**
   * Reads a lane.
   *
   * @param from s of its section
   */
  Lane read(CheckedElement element, int id, double from) {
    List<CheckedElement> widths = element.children("width");
    List<CheckedElement> borders = element.children("border");
    Lane.Shape shape =
        new Lane.Shape(
            records.profile(widths, "sOffset", from),
            // Where a lane has both, the width holds.
            widths.isEmpty() && !borders.isEmpty()
                ? Optional.of(records.profile(borders, "sOffset", from))
                : Optional.empty(),
            height(element, "inner", from),
            height(element, "outer", from));
    return new Lane(
        id,
        element.optional("type").orElse("none"),
        List.of("true", "1").contains(element.optional("level").orElse("")),
        element.choice("direction", List.of(Lane.Direction.values()), LaneReader::spelling),
        shape,
        element.children("roadMark").stream().map(mark -> mark(mark, from)).toList(),
        limits(element, from));
  }

  private static String spelling(Lane.Direction direction) {
    return direction.name().toLowerCase(Locale.ROOT);
  }

  private static Profile height(CheckedElement element, String attribute, double from) {
    List<CheckedElement> heights = element.children("height");
    if (heights.isEmpty()) {
      return Profile.ZERO;
    }
    return new Profile(
        heights.stream()
            .map(
                height ->
                    new Profile.Piece(
                        from + height.number("sOffset"),
                        new Cubic(height.number(attribute), 0, 0, 0)))
            .toList());
  }

  private List<Road.SpeedLimit> limits(CheckedElement element, double from) {
    List<CheckedElement> speeds = element.children("speed");
    if (speeds.isEmpty()) {
      return List.of();
    }
    records.requireOrder(speeds, "sOffset");
    return speeds.stream()
        .map(speed -> new Road.SpeedLimit(from + speed.number("sOffset"), RoadReader.speed(speed)))
        .toList();
  }

  private static RoadMark mark(CheckedElement element, double from) {
    return new RoadMark(
        from + element.number("sOffset", 0),
        element.optional("type").orElse("none"),
        element.optional("color").orElse("standard"),
        element.optional("weight").orElse("standard"),
        element.number("width", 0),
        element.optional("laneChange").orElse("both"),
        lines(element));
  }

  private static List<RoadMark.Line> lines(CheckedElement mark) {
    List<RoadMark.Line> lines = new ArrayList<>(0);
    for (CheckedElement line : mark.children("type", "line")) {
      lines.add(
          new RoadMark.Line(
              line.number("length"),
              line.number("space"),
              line.number("tOffset"),
              line.number("sOffset"),
              line.number("width", 0)));
    }
    return lines;
  }

  /** Reports where the width of a lane is unknown, negative, or on the wrong side. */
  void requireWidth(CheckedElement element, Lane lane, double start, double end) {
    double[] starts = lane.breaks();
    if (starts.length == 0 || starts[0] > start + Profile.ROUNDING) {
      problems.add(
          RoadRules.LANE_WIDTH,
          element,
          starts.length == 0
              ? "The lane has neither `width` nor `border`."
              : "The lane's width is unknown before s = " + starts[0] + ".",
          "Add a `width` with `sOffset=\"0\"`.");
      return;
    }
    double least = least(lane, start, end);
    if (least < -NEARLY_NOTHING && element.children("width").isEmpty()) {
      problems.add(
          RoadRules.LANE_WIDTH,
          element,
          "The lane's border is on the other side of lane 0.",
          "Borders are places t: above 0 on the left, below 0 on the right.");
    } else if (least < -NEARLY_NOTHING) {
      problems.add(
          RoadRules.LANE_WIDTH_NEGATIVE,
          element,
          "The lane is "
              + Math.round(least * 1000) / 1000.0
              + " m wide somewhere; 0 is used there.",
          "Correct the coefficients of its `width`.");
    }
  }

  /** Returns the least width, or distance of a border from lane 0, at places along the lane. */
  private static double least(Lane lane, double start, double end) {
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i <= 16; i++) {
      least = Math.min(least, lane.statedWidth(start + (end - start) * i / 16));
    }
    return least;
  }
}
