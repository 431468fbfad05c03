package dev.eventchain.roads.reader;

import dev.eventchain.roads.road.Pose;
import dev.eventchain.roads.road.Road;
import dev.eventchain.roads.road.RoadObject;
import dev.eventchain.roads.road.RoadObject.Body;
import dev.eventchain.roads.road.RoadObject.Corner;
import dev.eventchain.roads.road.RoadObject.Outline;
import dev.eventchain.roads.xml.CheckedElement;
import dev.eventchain.roads.xml.Problems;
import dev.eventchain.roads.xml.XmlRules;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** Reader of a road's objects. */
final class ObjectsReader {

  /** Length of the parts of a continuous object, such as a barrier, in m. */
  private static final double PART = 5;

  private static final int MOST_REPETITIONS = 10_000;

  private final Problems problems;
  private final Road road;

  ObjectsReader(Problems problems, Road road) {
    this.problems = problems;
    this.road = road;
  }

  List<RoadObject> read(CheckedElement element) {
    return element.children("objects", "object").stream().map(this::object).toList();
  }

  private RoadObject object(CheckedElement element) {
    List<Body> bodies = new ArrayList<>();
    List<CheckedElement> repeats = element.children("repeat");
    repeats.forEach(repeat -> repeat(element, repeat, bodies));
    if (repeats.isEmpty()) {
      bodies.add(single(element));
    }
    return new RoadObject(
        element.string("id"),
        element.optional("type").orElse(""),
        element.optional("subtype").orElse(""),
        element.optional("name").orElse(""),
        element.choice("dynamic", List.of("no", "yes"), value -> value).equals("yes"),
        bodies);
  }

  private Body single(CheckedElement element) {
    double s = element.number("s");
    Pose pose = pose(element, s, element.number("t"), element.number("zOffset", 0));
    Optional<Double> radius = element.optional("radius").map(r -> element.number("radius"));
    return new Body(
        pose,
        element.number("length", 0),
        element.number("width", 0),
        element.number("height", 0),
        radius.filter(value -> value > 0),
        outlines(element, pose, 0, 0));
  }

  private Pose pose(CheckedElement element, double s, double t, double height) {
    Pose on = road.pose(s, t, height);
    return new Pose(
        on.x(),
        on.y(),
        on.z(),
        on.heading() + element.number("hdg", 0),
        element.number("pitch", 0),
        element.number("roll", 0));
  }

  private void repeat(CheckedElement element, CheckedElement repeat, List<Body> bodies) {
    double length = repeat.number("length");
    double distance = repeat.number("distance");
    boolean continuous = distance == 0;
    double step = continuous ? length / Math.max(1, Math.ceil(length / PART)) : distance;
    double count = continuous ? length / step : Math.floor(length / step + 1e-9) + 1;
    if (!(step > 0) || count > MOST_REPETITIONS) {
      problems.add(
          XmlRules.VALUE,
          repeat.at("distance"),
          "The object is repeated each " + distance + " m on " + length + " m.",
          "`length` is above 0, `distance` 0 or more, and "
              + MOST_REPETITIONS
              + " bodies the most.");
      return;
    }
    for (int i = 0; i < Math.round(count); i++) {
      double along = continuous ? (i + 0.5) * step : i * step;
      bodies.add(repeated(element, repeat, along, continuous ? step : 0));
    }
  }

  /**
   * Returns one of the bodies of a repetition.
   *
   * @param part the length of a part of a continuous object; 0 for separate ones
   */
  private Body repeated(CheckedElement element, CheckedElement repeat, double along, double part) {
    double share = along / repeat.number("length");
    double s = repeat.number("s") + along;
    double t = between(repeat, "t", share, element.number("t"));
    Pose pose = pose(element, s, t, between(repeat, "zOffset", share, 0));
    double radius = between(repeat, "radius", share, element.number("radius", 0));
    return new Body(
        pose,
        part > 0 ? part : between(repeat, "length", share, element.number("length", 0)),
        between(repeat, "width", share, element.number("width", 0)),
        between(repeat, "height", share, element.number("height", 0)),
        radius > 0 && part == 0 ? Optional.of(radius) : Optional.empty(),
        part > 0
            ? List.of()
            : outlines(element, pose, s - element.number("s"), t - element.number("t")));
  }

  private static double between(CheckedElement repeat, String name, double share, double absent) {
    double start = repeat.number(name + "Start", absent);
    return start + share * (repeat.number(name + "End", start) - start);
  }

  /**
   * Returns the outlines of a body.
   *
   * @param ds the distance along the road to where the object itself is
   * @param dt the same across the road
   */
  private List<Outline> outlines(CheckedElement element, Pose origin, double ds, double dt) {
    Stream<CheckedElement> elements =
        Stream.concat(
            element.children("outline").stream(), element.children("outlines", "outline").stream());
    return elements
        .map(
            outline ->
                new Outline(
                    !outline.optional("closed").orElse("true").equals("false"),
                    outline.children().stream()
                        .filter(child -> child.name().startsWith("corner"))
                        .map(corner -> corner(corner, origin, ds, dt))
                        .toList()))
        .toList();
  }

  private Corner corner(CheckedElement corner, Pose origin, double ds, double dt) {
    if (corner.name().equals("cornerRoad")) {
      Pose on = road.pose(corner.number("s") + ds, corner.number("t") + dt, corner.number("dz"));
      return new Corner(on.x(), on.y(), on.z(), corner.number("height"));
    }
    double u = corner.number("u");
    double v = corner.number("v");
    double cos = StrictMath.cos(origin.heading());
    double sin = StrictMath.sin(origin.heading());
    return new Corner(
        origin.x() + u * cos - v * sin,
        origin.y() + u * sin + v * cos,
        origin.z() + corner.number("z"),
        corner.number("height"));
  }
}
