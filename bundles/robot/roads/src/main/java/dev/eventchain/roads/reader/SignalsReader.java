package dev.eventchain.roads.reader;

import dev.eventchain.roads.road.Pose;
import dev.eventchain.roads.road.Road;
import dev.eventchain.roads.road.Signal;
import dev.eventchain.roads.xml.CheckedElement;
import dev.eventchain.roads.xml.Problems;
import dev.eventchain.roads.xml.XmlRules;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;

/** Reader of a road's signals. */
final class SignalsReader {

  private final Problems problems;
  private final Road road;

  SignalsReader(Problems problems, Road road) {
    this.problems = problems;
    this.road = road;
  }

  List<Signal> read(CheckedElement element) {
    return element.children("signals", "signal").stream().map(this::signal).toList();
  }

  List<Signal.Reference> references(CheckedElement element) {
    return element.children("signals", "signalReference").stream()
        .map(
            reference ->
                new Signal.Reference(
                    reference.string("id"),
                    reference.number("s"),
                    reference.number("t"),
                    orientation(reference),
                    lanes(reference)))
        .toList();
  }

  private Signal signal(CheckedElement element) {
    return new Signal(
        element.string("id"),
        element.optional("name").orElse(""),
        element.choice("dynamic", List.of("no", "yes"), value -> value).equals("yes"),
        orientation(element),
        element.optional("country").orElse(""),
        element.optional("type").orElse(""),
        element.optional("subtype").orElse(""),
        element.optional("value").isPresent() && element.isNumber("value")
            ? OptionalDouble.of(element.number("value"))
            : OptionalDouble.empty(),
        element.optional("unit").orElse(""),
        element.optional("text").orElse(""),
        element.number("s"),
        pose(element),
        element.number("width", 0),
        element.number("height", 0),
        lanes(element));
  }

  private static Signal.Orientation orientation(CheckedElement element) {
    return element.choice(
        "orientation", List.of(Signal.Orientation.values()), Signal.Orientation::spelling);
  }

  private Pose pose(CheckedElement element) {
    Optional<CheckedElement> inertial = element.child("positionInertial");
    Optional<CheckedElement> onRoad = element.child("positionRoad");
    if (inertial.isPresent()) {
      CheckedElement place = inertial.get();
      return new Pose(
          place.number("x"),
          place.number("y"),
          place.number("z"),
          place.number("hdg"),
          place.number("pitch", 0),
          place.number("roll", 0));
    } else if (onRoad.isPresent()) {
      requireThisRoad(onRoad.get());
      return pose(onRoad.get(), 0);
    }
    boolean against = orientation(element) == Signal.Orientation.AGAINST_S;
    return pose(element, against ? Math.PI : 0);
  }

  private void requireThisRoad(CheckedElement place) {
    if (!place.string("roadId").equals(road.id())) {
      problems.add(
          XmlRules.ELEMENT_UNSUPPORTED,
          place,
          "The signal stands at another road than the one it is for.",
          "Use `positionInertial`, or a `signalReference` from the road that it is for.");
    }
  }

  private Pose pose(CheckedElement element, double turned) {
    double height = element.number("zOffset", 0);
    Pose on = road.pose(element.number("s"), element.number("t"), height);
    return new Pose(
        on.x(),
        on.y(),
        on.z(),
        on.heading() + turned + element.number("hOffset", 0),
        element.number("pitch", 0),
        element.number("roll", 0));
  }

  private static Optional<List<Integer>> lanes(CheckedElement element) {
    List<CheckedElement> validities = element.children("validity");
    return validities.isEmpty()
        ? Optional.empty()
        : Optional.of(
            validities.stream()
                .flatMapToInt(each -> range(each.integer("fromLane"), each.integer("toLane")))
                .boxed()
                .toList());
  }

  /** Returns the lanes of a range; of one beyond all reason, its ends. */
  private static IntStream range(int first, int second) {
    int low = Math.min(first, second);
    int high = Math.max(first, second);
    return (long) high - low > 1000 ? IntStream.of(low, high) : IntStream.rangeClosed(low, high);
  }
}
