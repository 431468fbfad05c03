package dev.eventchain.openscenario.storyboard.condition;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.condition.EntityTests.OfOne;
import dev.eventchain.openscenario.storyboard.position.Body;
import dev.eventchain.openscenario.storyboard.position.Measure;
import dev.eventchain.openscenario.storyboard.position.Position;
import dev.eventchain.openscenario.storyboard.position.Positions;
import dev.eventchain.openscenario.storyboard.scene.Actor;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import java.util.Optional;
import java.util.OptionalDouble;

/** Expressions on where an entity is. */
final class DistanceTests {

  /** Target of a distance; empty while it is not in the world. */
  @FunctionalInterface
  private interface Target {
    Optional<Body> in(Scene scene);
  }

  private DistanceTests() {}

  static OfOne read(ScenarioElement condition) {
    return switch (condition.name()) {
      case "ReachPositionCondition" -> reach(condition);
      case "DistanceCondition" -> distance(condition, position(condition));
      case "RelativeDistanceCondition" -> distance(condition, entity(condition));
      case "TimeHeadwayCondition" -> headway(condition);
      case "TimeToCollisionCondition" -> collision(condition);
      default -> AngleTests.read(condition);
    };
  }

  private static Target position(ScenarioElement element) {
    Position position = Positions.read(element.required("Position"));
    return scene -> Optional.of(Body.of(position.in(scene)));
  }

  private static Target entity(ScenarioElement element) {
    String name = element.text("entityRef");
    return scene ->
        Optional.of(scene.actor(name)).filter(each -> each.state().exists()).map(Body::of);
  }

  private static OfOne reach(ScenarioElement condition) {
    Position position = Positions.read(condition.required("Position"));
    double tolerance = condition.number("tolerance");
    return (scene, actor) ->
        Comparison.LESS_OR_EQUAL.holds(
            actor.state().pose().distance(position.in(scene).pose()), tolerance);
  }

  private static OfOne distance(ScenarioElement condition, Target target) {
    Comparison rule = Comparison.of(condition);
    double value = condition.number("value");
    Measure measure = Measure.of(condition);
    return (scene, actor) -> {
      Optional<Body> to = target.in(scene);
      return to.isPresent() && rule.holds(measure.distance(scene, Body.of(actor), to.get()), value);
    };
  }

  /** The time in which the entity gets where the other one is; none while it stands. */
  private static OfOne headway(ScenarioElement condition) {
    Comparison rule = Comparison.of(condition);
    double value = condition.number("value");
    Measure measure = Measure.of(condition);
    Target target = entity(condition);
    return (scene, actor) -> {
      Optional<Body> to = target.in(scene);
      return to.isPresent()
          && rule.holds(
              quotient(
                  measure.distance(scene, Body.of(actor), to.get()),
                  OptionalDouble.of(Math.abs(actor.state().speed()))),
              value);
    };
  }

  /** The time until the distance is gone at the present velocities; none while it grows. */
  private static OfOne collision(ScenarioElement condition) {
    Comparison rule = Comparison.of(condition);
    double value = condition.number("value");
    Measure measure = Measure.of(condition);
    ScenarioElement aim = condition.required("TimeToCollisionConditionTarget");
    Target target =
        aim.child("Position").isPresent() ? position(aim) : entity(aim.required("EntityRef"));
    return (scene, actor) -> {
      Optional<Body> to = target.in(scene);
      return to.isPresent() && rule.holds(timeToCollision(scene, measure, actor, to.get()), value);
    };
  }

  private static OptionalDouble timeToCollision(
      Scene scene, Measure measure, Actor actor, Body to) {
    Body from = Body.of(actor);
    return quotient(measure.distance(scene, from, to), measure.closing(scene, from, to));
  }

  /** Returns a time; empty for a speed that is not clearly greater than 0. */
  private static OptionalDouble quotient(OptionalDouble distance, OptionalDouble speed) {
    return distance.isPresent() && speed.isPresent() && speed.getAsDouble() > 1e-6
        ? OptionalDouble.of(distance.getAsDouble() / speed.getAsDouble())
        : OptionalDouble.empty();
  }
}
