package dev.eventchain.openscenario.storyboard.action;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.position.Body;
import dev.eventchain.openscenario.storyboard.position.Measure;
import dev.eventchain.openscenario.storyboard.scene.Actor;
import dev.eventchain.openscenario.storyboard.scene.KeepLane;
import dev.eventchain.openscenario.storyboard.scene.LaneWay;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.scene.Task;
import dev.eventchain.openscenario.storyboard.world.ControlDomain;
import dev.eventchain.openscenario.storyboard.world.EntityState;
import dev.eventchain.openscenario.storyboard.world.StoryboardRules;
import java.util.Optional;

/**
 * A distance or a time gap to another entity. Without dynamic constraints it is there at once; with
 * them it is approached as fast as they allow.
 */
final class LongitudinalDistance {

  private final ScenarioElement action;
  private final String other;
  private final Measure measure;
  private final boolean continuous;

  private LongitudinalDistance(ScenarioElement action) {
    this.action = action;
    other = action.text("entityRef");
    continuous = action.flag("continuous");
    measure =
        new Measure(Measure.Kind.LONGITUDINAL, Measure.frame(action), action.flag("freespace"));
  }

  static PrivateAction read(ScenarioElement action) {
    return new LongitudinalDistance(action)::start;
  }

  private Optional<Task> start(Scene scene, Actor actor) {
    boolean trailing = trails(scene, actor);
    Optional<Limits> limits = action.child("DynamicConstraints").map(Limits::of);
    if (limits.isEmpty()) {
      jump(scene, actor, error(scene, actor, Body.of(scene.actor(other)), trailing));
    }
    Task task = new Task(actor.entity().name());
    if (limits.isEmpty() && !continuous) {
      return Optional.empty();
    }
    actor.drive(
        scene,
        task,
        limits.isEmpty()
            ? new GapHolding(this, trailing)
            : new GapClosing(this, trailing, limits.get(), continuous));
    return Optional.of(task);
  }

  private boolean trails(Scene scene, Actor actor) {
    return switch (action.optional("displacement").orElse("any")) {
      case "trailingReferencedEntity" -> true;
      case "leadingReferencedEntity" -> false;
      default -> {
        Measure points = new Measure(measure.kind(), measure.frame(), false);
        yield points.gap(scene, Body.of(actor), Body.of(scene.actor(other)), true).orElse(0) >= 0;
      }
    };
  }

  /** Returns how far the actor has to go forward to be where it should be. */
  double error(Scene scene, Actor actor, Body reference, boolean trailing) {
    double gap =
        measure
            .gap(scene, Body.of(actor), reference, trailing)
            .orElseThrow(
                () ->
                    StoryboardRules.failure(
                        StoryboardRules.NO_PLACE,
                        "No road leads from '" + actor.entity().name() + "' to '" + other + "'.",
                        action.location(),
                        "Place both on roads that are connected."));
    double aim =
        action.has("distance")
            ? action.number("distance")
            : action.number("timeGap")
                * Math.abs((trailing ? actor.state() : scene.state(other)).speed());
    return trailing ? gap - aim : aim - gap;
  }

  /** Returns the time gap in s; 0 for a distance. */
  double time() {
    return action.number("timeGap", 0);
  }

  /** Returns the other one. */
  EntityState reference(Scene scene) {
    return scene.state(other);
  }

  /** Returns the other one after a step in which it keeps its acceleration. */
  Body referenceAfter(Scene scene, double dt) {
    Body now = Body.of(scene.actor(other));
    EntityState state = scene.state(other);
    double half = state.acceleration() * dt / 2;
    double heading = state.pose().heading();
    return new Body(
            now.pose(),
            now.box(),
            now.road(),
            now.vx() + half * StrictMath.cos(heading),
            now.vy() + half * StrictMath.sin(heading))
        .after(scene, dt);
  }

  private static void jump(Scene scene, Actor actor, double distance) {
    if (actor.decides(ControlDomain.LONGITUDINAL)) {
      return;
    }
    EntityState before = actor.state();
    if (actor.lateral() instanceof KeepLane lane) {
      Optional<LaneWay> there = lane.way().moved(scene, distance, actor.route());
      if (there.isPresent()) {
        double heading = there.get().pose(scene).heading() + lane.turned();
        actor.place(
            scene,
            EntityState.along(
                    there.get().pose(scene).withHeading(heading),
                    before.speed(),
                    Optional.of(there.get().point()))
                .withVisibility(before.visibility()));
        return;
      }
    }
    actor.place(
        scene,
        EntityState.along(
                before.pose().moved(distance, 0),
                before.speed(),
                scene.roads().find(before.pose().moved(distance, 0)))
            .withVisibility(before.visibility()));
  }
}
