package dev.eventchain.openscenario.document;

import dev.eventchain.documents.XmlElement;
import dev.eventchain.openscenario.vocabulary.AttributeType;
import dev.eventchain.openscenario.vocabulary.ElementType;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Elements in the form of the latest version, so that whoever plays them sees one form only: names
 * of attributes, values that are meant where an attribute is left out, and what has moved.
 */
final class LatestForm {

  /** Contents that have moved into an element of their own, by type and child. */
  private static final Map<String, Map<String, String>> MOVED =
      Map.of(
          "PrivateAction", Map.of("ActivateControllerAction", "ControllerAction"),
          "AssignControllerAction", Map.of("Controller", "ObjectController"),
          "FollowTrajectoryAction", Map.of("Trajectory", "TrajectoryRef"));

  private static final Map<String, String> RENAMED =
      Map.of("TrafficeSignalGroupState", "TrafficSignalGroupState");

  private LatestForm() {}

  static ScenarioElement of(
      ElementType type,
      XmlElement element,
      Map<String, String> values,
      List<ScenarioElement> children) {
    Map<String, String> moved = MOVED.getOrDefault(type.name(), Map.of());
    List<ScenarioElement> latest =
        children.stream()
            .map(
                child ->
                    moved.containsKey(child.name())
                        ? new ScenarioElement(
                            moved.get(child.name()), child.written(), Map.of(), List.of(child))
                        : child)
            .toList();
    String name = RENAMED.getOrDefault(element.name(), element.name());
    return new ScenarioElement(name, element, values(type, values), latest);
  }

  private static Map<String, String> values(ElementType type, Map<String, String> written) {
    Map<String, String> values = new LinkedHashMap<>(written);
    for (AttributeType attribute : type.attributes().values()) {
      String value = written.get(attribute.name());
      if (value != null && !attribute.latest().equals(attribute.name())) {
        values.remove(attribute.name());
        values.putIfAbsent(attribute.latest(), value);
      }
    }
    if (Boolean.parseBoolean(values.remove("alongRoute"))) {
      values.putIfAbsent("coordinateSystem", "road");
      values.putIfAbsent("relativeDistanceType", "longitudinal");
    }
    for (AttributeType attribute : type.attributes().values()) {
      Optional<String> otherwise = attribute.otherwise();
      otherwise.ifPresent(value -> values.putIfAbsent(attribute.name(), value));
    }
    return values;
  }
}
