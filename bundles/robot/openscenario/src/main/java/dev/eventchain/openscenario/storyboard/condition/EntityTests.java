package dev.eventchain.openscenario.storyboard.condition;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.scene.Actor;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import java.util.ArrayList;
import java.util.List;

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
    switch (condition.name()) {
      case "EndOfRoadCondition":
        double end = condition.number("duration");
        return (scene, actor) -> lasts(actor.odometer().atEnd(), end);
      case "OffroadCondition":
        double off = condition.number("duration");
        return (scene, actor) -> lasts(actor.odometer().offRoad(), off);
      case "StandStillCondition":
        double still = condition.number("duration");
        return (scene, actor) -> lasts(actor.odometer().standing(), still);
      case "TraveledDistanceCondition":
        double way = condition.number("value");
        return (scene, actor) ->
            Comparison.GREATER_OR_EQUAL.holds(actor.odometer().travelled(), way);
      default:
        return MotionTests.read(condition);
    }
  }

  private static boolean lasts(double duration, double least) {
    return duration >= 0 && Comparison.GREATER_OR_EQUAL.holds(duration, least);
  }
}
