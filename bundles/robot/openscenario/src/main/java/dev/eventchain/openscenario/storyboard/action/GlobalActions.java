package dev.eventchain.openscenario.storyboard.action;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.position.Position;
import dev.eventchain.openscenario.storyboard.position.Positions;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.scene.Surroundings;
import dev.eventchain.openscenario.storyboard.scene.Values;
import dev.eventchain.openscenario.storyboard.world.EntityState;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;

/** Actions of no entity. All are done at once. */
final class GlobalActions {

  private GlobalActions() {}

  static Action read(ScenarioElement action) {
    return switch (action.name()) {
      case "EnvironmentAction" -> environment(action);
      case "EntityAction" -> entity(action);
      case "ParameterAction" -> value(action, "parameterRef", Scene::parameters);
      case "VariableAction" -> value(action, "variableRef", Scene::variables);
      case "InfrastructureAction" -> signal(action.required("TrafficSignalAction").choice());
      case "SetMonitorAction" -> Action.NONE;
      default -> throw new IllegalArgumentException(action.name() + " is not supported");
    };
  }

  private static Action atOnce(Consumer<Scene> effect) {
    return (scene, actors) -> {
      effect.accept(scene);
      return List.of();
    };
  }

  private static Action environment(ScenarioElement action) {
    ScenarioElement environment = action.required("Environment");
    return atOnce(
        scene -> {
          environment
              .child("RoadCondition")
              .ifPresent(road -> scene.surroundings().friction(road.number("frictionScaleFactor")));
          environment
              .child("TimeOfDay")
              .ifPresent(
                  time ->
                      scene
                          .surroundings()
                          .timeOfDay(
                              Surroundings.date(time.text("dateTime")), time.flag("animation")));
        });
  }

  private static Action entity(ScenarioElement action) {
    String name = action.text("entityRef");
    ScenarioElement kind = action.choice();
    if (kind.name().equals("DeleteEntityAction")) {
      return atOnce(
          scene ->
              scene
                  .entities()
                  .named(name)
                  .forEach(each -> scene.actor(each).place(scene, EntityState.ABSENT)));
    }
    Position position = Positions.read(kind.required("Position"));
    return atOnce(
        scene ->
            scene.entities().named(name).stream()
                .map(scene::actor)
                .forEach(each -> TeleportActions.teleport(scene, each, position)));
  }

  private static Action value(
      ScenarioElement action, String reference, Function<Scene, Values> values) {
    String name = action.text(reference);
    ScenarioElement kind = action.choice();
    if (kind.name().equals("SetAction")) {
      String value = kind.text("value");
      return atOnce(scene -> values.apply(scene).set(name, value));
    }
    ScenarioElement rule = kind.required("Rule").choice();
    double value = rule.number("value");
    return rule.name().equals("AddValue")
        ? atOnce(scene -> values.apply(scene).add(name, value))
        : atOnce(scene -> values.apply(scene).multiply(name, value));
  }

  private static Action signal(ScenarioElement action) {
    if (action.name().equals("TrafficSignalStateAction")) {
      return atOnce(scene -> scene.signals().set(action.text("name"), action.text("state")));
    }
    return atOnce(
        scene ->
            scene
                .signals()
                .enter(
                    action.text("trafficSignalControllerRef"), action.text("phase"), scene.time()));
  }
}
