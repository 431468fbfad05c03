package dev.eventchain.openscenario.storyboard.condition;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.condition.EntityTests.OfOne;
import dev.eventchain.openscenario.storyboard.scene.Actor;
import dev.eventchain.openscenario.storyboard.world.EntityState;

/** Expressions on how an entity moves. */
final class MotionTests {

  private MotionTests() {}

  static OfOne read(ScenarioElement condition) {
    return switch (condition.name()) {
      case "SpeedCondition" -> speed(condition);
      case "RelativeSpeedCondition" -> relativeSpeed(condition);
      case "AccelerationCondition" -> acceleration(condition);
      case "CollisionCondition" -> collision(condition);
      default -> DistanceTests.read(condition);
    };
  }

  /** Without a direction, the speed has no sign. */
  private static OfOne speed(ScenarioElement condition) {
    Comparison rule = Comparison.of(condition);
    double value = condition.number("value");
    String direction = condition.optional("direction").orElse("");
    return (scene, actor) -> {
      double speed = speed(actor.state(), direction);
      return rule.holds(direction.isEmpty() ? Math.abs(speed) : speed, value);
    };
  }

  private static double speed(EntityState state, String direction) {
    double heading = state.pose().heading();
    return switch (direction) {
      case "longitudinal" ->
          state.vx() * StrictMath.cos(heading) + state.vy() * StrictMath.sin(heading);
      case "lateral" -> state.vy() * StrictMath.cos(heading) - state.vx() * StrictMath.sin(heading);
      case "vertical" -> 0;
      default -> state.speed();
    };
  }

  /** The speed of the triggering entity minus that of the reference, each along its own axes. */
  private static OfOne relativeSpeed(ScenarioElement condition) {
    Comparison rule = Comparison.of(condition);
    double value = condition.number("value");
    String other = condition.text("entityRef");
    String direction = condition.optional("direction").orElse("");
    return (scene, actor) ->
        scene.state(other).exists()
            && rule.holds(
                speed(actor.state(), direction) - speed(scene.state(other), direction), value);
  }

  private static OfOne acceleration(ScenarioElement condition) {
    Comparison rule = Comparison.of(condition);
    double value = condition.number("value");
    String direction = condition.optional("direction").orElse("");
    return (scene, actor) -> {
      EntityState state = actor.state();
      double actual =
          switch (direction) {
            case "longitudinal" -> state.acceleration();
            case "lateral" -> state.lateralAcceleration();
            case "vertical" -> 0;
            default -> StrictMath.hypot(state.acceleration(), state.lateralAcceleration());
          };
      return rule.holds(actual, value);
    };
  }

  private static OfOne collision(ScenarioElement condition) {
    ScenarioElement target = condition.choice();
    if (target.name().equals("EntityRef")) {
      String other = target.text("entityRef");
      return (scene, actor) ->
          scene.entities().named(other).stream()
              .anyMatch(each -> scene.collisions().touch(actor.entity().name(), each));
    }
    String type = target.text("type");
    return (scene, actor) ->
        scene.actors().stream()
            .filter(each -> each.entity().kind().equals(type) && each != actor)
            .map(Actor::entity)
            .anyMatch(each -> scene.collisions().touch(actor.entity().name(), each.name()));
  }
}
