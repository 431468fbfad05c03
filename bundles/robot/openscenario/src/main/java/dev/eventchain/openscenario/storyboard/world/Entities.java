package dev.eventchain.openscenario.storyboard.world;

import dev.eventchain.openscenario.document.ScenarioElement;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The entities of a scenario and its selections of entities, in their order. */
public final class Entities {

  private static final Box NO_BOX = new Box(0, 0, 0, 0, 0, 0);

  private final Map<String, Entity> objects = new LinkedHashMap<>();
  private final Map<String, List<String>> selections = new LinkedHashMap<>();

  private Entities() {}

  /** Reads them from a scenario. */
  public static Entities of(ScenarioElement scenario) {
    Entities result = new Entities();
    ScenarioElement entities = scenario.required("Entities");
    for (ScenarioElement each : entities.children("ScenarioObject")) {
      result.objects.putIfAbsent(each.text("name"), entity(each));
    }
    for (ScenarioElement each : entities.children("EntitySelection")) {
      result.selections.putIfAbsent(each.text("name"), result.members(each.required("Members")));
    }
    return result;
  }

  private List<String> members(ScenarioElement members) {
    List<String> named =
        members.children("EntityRef").stream().map(each -> each.text("entityRef")).toList();
    List<String> types =
        members.children("ByType").stream().map(each -> each.text("objectType")).toList();
    return objects.values().stream()
        .filter(each -> named.contains(each.name()) || types.contains(each.kind()))
        .map(Entity::name)
        .toList();
  }

  private static Entity entity(ScenarioElement object) {
    return object.children().stream()
        .flatMap(each -> shown(object, each).stream())
        .findFirst()
        .orElseGet(
            () ->
                new Entity(
                    object.text("name"), "external", "", NO_BOX, Performance.UNLIMITED, 0, object));
  }

  private static Optional<Entity> shown(ScenarioElement object, ScenarioElement child) {
    return switch (child.name()) {
      case "Vehicle" -> Optional.of(entity(object, child, "vehicle", "vehicleCategory"));
      case "Pedestrian" -> Optional.of(entity(object, child, "pedestrian", "pedestrianCategory"));
      case "MiscObject" ->
          Optional.of(entity(object, child, "miscellaneous", "miscObjectCategory"));
      default -> Optional.empty();
    };
  }

  private static Entity entity(
      ScenarioElement object, ScenarioElement shown, String kind, String attribute) {
    return new Entity(
        object.text("name"),
        kind,
        shown.text(attribute),
        shown.child("BoundingBox").map(Entities::box).orElse(NO_BOX),
        shown.child("Performance").map(Entities::performance).orElse(Performance.UNLIMITED),
        shown.number("mass", 0),
        object);
  }

  private static Box box(ScenarioElement box) {
    ScenarioElement center = box.required("Center");
    ScenarioElement dimensions = box.required("Dimensions");
    return new Box(
        center.number("x"),
        center.number("y"),
        center.number("z"),
        dimensions.number("length"),
        dimensions.number("width"),
        dimensions.number("height"));
  }

  private static Performance performance(ScenarioElement limits) {
    return new Performance(
        limits.number("maxSpeed"),
        limits.number("maxAcceleration"),
        limits.number("maxDeceleration"));
  }

  /** Returns the scenario objects by name, in their order. */
  public Map<String, Entity> objects() {
    return objects;
  }

  public Optional<Entity> find(String name) {
    return Optional.ofNullable(objects.get(name));
  }

  /** Returns whether a name is that of an object or of a selection. */
  public boolean knows(String name) {
    return objects.containsKey(name) || selections.containsKey(name);
  }

  /** Returns the objects that a name stands for: one, or those of a selection. */
  public List<String> named(String name) {
    return selections.getOrDefault(name, List.of(name));
  }
}
