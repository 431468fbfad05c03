package dev.eventchain.openscenario.storyboard.condition;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.scene.Actor;
import dev.eventchain.openscenario.storyboard.scene.Odometer;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;

/** Expressions on entities. */
final class EntityTests {

  /** An expression on one entity. */
  @FunctionalInterface
  interface OfOne {
    boolean holds(Scene scene, Actor actor);
  }

  private EntityTests() {}

  static Test read(ScenarioElement written) {
    ScenarioElement triggering = written.required("TriggeringEntities");
    List<String> names =
        triggering.children("EntityRef").stream().map(each -> each.text("entityRef")).toList();
    boolean all = triggering.text("triggeringEntitiesRule").equals("all");
    OfOne test = one(written.required("EntityCondition").choice());
    return scene -> of(scene, names, all, test);
  }

  /** An entity that is not in the world fulfils no condition. */
  private static Outcome of(Scene scene, List<String> names, boolean all, OfOne test) {
    List<String> entities = new ArrayList<>();
    int count = 0;
    for (String name : names) {
      for (String entity : scene.entities().named(name)) {
        count++;
        Actor actor = scene.actor(entity);
        if (actor.state().exists() && test.holds(scene, actor)) {
          entities.add(entity);
        }
      }
    }
    boolean holds = all ? count > 0 && entities.size() == count : !entities.isEmpty();
    return holds ? new Outcome(true, List.copyOf(entities)) : Outcome.NO;
  }

  private static OfOne one(ScenarioElement condition) {
    return switch (condition.name()) {
      case "EndOfRoadCondition" -> lasting(condition, Odometer::atEnd);
      case "OffroadCondition" -> lasting(condition, Odometer::offRoad);
      case "StandStillCondition" -> lasting(condition, Odometer::standing);
      case "TraveledDistanceCondition" -> travelled(condition);
      default -> MotionTests.read(condition);
    };
  }

  /** A duration that is negative has not begun. */
  private static OfOne lasting(ScenarioElement condition, ToDoubleFunction<Odometer> duration) {
    double least = condition.number("duration");
    return (scene, actor) -> {
      double now = duration.applyAsDouble(actor.odometer());
      return now >= 0 && Comparison.GREATER_OR_EQUAL.holds(now, least);
    };
  }

  private static OfOne travelled(ScenarioElement condition) {
    double way = condition.number("value");
    return (scene, actor) -> Comparison.GREATER_OR_EQUAL.holds(actor.odometer().travelled(), way);
  }
}
