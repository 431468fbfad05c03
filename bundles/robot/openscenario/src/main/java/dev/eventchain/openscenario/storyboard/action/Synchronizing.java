package dev.eventchain.openscenario.storyboard.action;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.position.Position;
import dev.eventchain.openscenario.storyboard.position.Positions;
import dev.eventchain.openscenario.storyboard.scene.Actor;
import dev.eventchain.openscenario.storyboard.scene.Longitudinal;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.scene.Task;
import dev.eventchain.openscenario.storyboard.world.Performance;
import java.util.Optional;

/**
 * Arrives at a place when a master arrives at another one, as it looks at its present speed. In
 * each step the rest is planned anew, so that it also holds if the master brakes: with a constant
 * acceleration, or one that changes linearly where a final speed is given. If that would be
 * backward, the entity slows down to the mean speed of the rest; it waits while the master stands.
 */
record Synchronizing(String master, Arrival masterAim, Arrival aim, FinalSpeed last)
    implements Longitudinal {

  private static final double STANDING = 1e-3;

  static PrivateAction read(ScenarioElement action) {
    Position masterTarget = Positions.read(action.required("TargetPositionMaster"));
    Position target = Positions.read(action.required("TargetPosition"));
    FinalSpeed last = FinalSpeed.of(action);
    return (scene, actor) -> {
      Task task = new Task(actor.entity().name());
      actor.drive(
          scene,
          task,
          new Synchronizing(
              action.text("masterEntityRef"),
              new Arrival(masterTarget.in(scene), action.number("targetToleranceMaster", 0)),
              new Arrival(target.in(scene), action.number("targetTolerance", 0)),
              last));
      return Optional.of(task);
    };
  }

  @Override
  public Step step(Scene scene, Actor actor, double dt) {
    double distance = aim.distance(scene, actor);
    Actor other = scene.actor(master);
    double masterDistance = masterAim.distance(scene, other);
    double masterSpeed = Math.abs(other.state().speed());
    double before = actor.state().speed();
    if (distance <= aim.tolerance() || masterDistance <= masterAim.tolerance()) {
      return new Step(before * dt, before, 0, this, true);
    }
    double time =
        masterSpeed > STANDING
            ? Math.max(dt, masterDistance / masterSpeed)
            : Double.POSITIVE_INFINITY;
    Plan plan = last.plan(scene, master, before, distance, time);
    double wanted = plan.speed(dt);
    Performance limits = actor.entity().performance();
    double speed =
        Math.max(
            before - limits.maxDeceleration() * dt,
            Math.min(before + limits.maxAcceleration() * dt, limits.limited(wanted)));
    double way = speed == wanted ? plan.distance(dt) : (before + speed) / 2 * dt;
    boolean there = distance - way <= Math.max(aim.tolerance(), SpeedChange.NOTHING);
    return new Step(way, speed, (speed - before) / dt, this, there);
  }

  /**
   * A course of speed: from a speed with an acceleration that changes linearly.
   *
   * @param jerk in m/s3
   */
  record Plan(double from, double acceleration, double jerk) {

    double speed(double time) {
      return from + time * (acceleration + jerk * time / 2);
    }

    double distance(double time) {
      return time * (from + time * (acceleration / 2 + jerk * time / 6));
    }

    /** Returns whether the speed gets negative before a time. */
    boolean isBackward(double until) {
      double lowest = jerk > 0 ? Math.max(0, Math.min(until, -acceleration / jerk)) : until;
      return speed(lowest) < -STANDING || speed(until) < -STANDING;
    }
  }
}
