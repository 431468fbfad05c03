package dev.eventchain.openscenario.storyboard.action;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.scene.Actor;
import dev.eventchain.openscenario.storyboard.scene.LaneWay;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.scene.Task;
import dev.eventchain.openscenario.storyboard.world.Box;
import java.util.Optional;

/**
 * A lateral distance to another entity, along the road; both are taken as parallel to it. The way
 * there has the shape of a cubic curve within the constraints.
 */
final class LateralDistance {

  private final ScenarioElement action;
  private final String other;
  private final boolean continuous;

  private LateralDistance(ScenarioElement action) {
    this.action = action;
    other = action.text("entityRef");
    continuous = action.flag("continuous");
  }

  static PrivateAction read(ScenarioElement action) {
    return new LateralDistance(action)::start;
  }

  private Optional<Task> start(Scene scene, Actor actor) {
    LaneWay own = LateralActions.way(scene, actor, action);
    LaneWay reference = LateralActions.way(scene, scene.actor(other), action);
    double apart = t(scene, own) - t(scene, reference);
    double side = side(apart, reference.alongS());
    double covered = covered(scene, actor, own, reference, side);
    double distance =
        action.has("distance")
            ? action.number("distance") + covered
            : Math.max(covered, Math.abs(apart));
    double target = side * distance;
    double change = Math.abs(target - apart);
    LaneShift.Target to = now -> offset(now, actor, target);
    double fixed = to.in(scene);
    return LateralActions.start(
        scene,
        actor,
        new LaneShift(
            own,
            Shape.CUBIC,
            own.point().offset(),
            continuous ? to : now -> fixed,
            duration(change),
            false,
            0,
            continuous));
  }

  /** Returns 1 for the left of the other one as one looks along s, and -1 for its right. */
  private double side(double apart, boolean alongS) {
    return switch (action.optional("displacement").orElse("any")) {
      case "leftToReferencedEntity" -> alongS ? 1 : -1;
      case "rightToReferencedEntity" -> alongS ? -1 : 1;
      default -> apart < 0 ? -1 : 1;
    };
  }

  private static double t(Scene scene, LaneWay way) {
    return scene.roads().road(way.point()).t();
  }

  /** Returns the distance between reference points of bodies that touch. */
  private double covered(Scene scene, Actor actor, LaneWay own, LaneWay reference, double side) {
    if (!action.flag("freespace")) {
      return 0;
    }
    Box box = actor.entity().box();
    Box others = scene.actor(other).entity().box();
    // The side of each that faces the other one.
    return box.width() / 2
        - side * (own.alongS() ? box.y() : -box.y())
        + others.width() / 2
        + side * (reference.alongS() ? others.y() : -others.y());
  }

  /** Returns the offset to the actor's lane that is so far from the other one. */
  private double offset(Scene scene, Actor actor, double target) {
    LaneWay own = LateralActions.way(scene, actor, action);
    LaneWay reference = LateralActions.way(scene, scene.actor(other), action);
    return own.point().offset() + t(scene, reference) + target - t(scene, own);
  }

  private double duration(double change) {
    Optional<ScenarioElement> limits = action.child("DynamicConstraints");
    double speed = limit(limits, "maxSpeed");
    double acceleration =
        Math.min(limit(limits, "maxAcceleration"), limit(limits, "maxDeceleration"));
    return Math.max(
        Shape.CUBIC.steepest() * change / speed,
        Math.sqrt(Shape.CUBIC.sharpest() * change / acceleration));
  }

  private static double limit(Optional<ScenarioElement> limits, String name) {
    return limits
        .map(each -> each.number(name, Double.POSITIVE_INFINITY))
        .orElse(Double.POSITIVE_INFINITY);
  }
}
