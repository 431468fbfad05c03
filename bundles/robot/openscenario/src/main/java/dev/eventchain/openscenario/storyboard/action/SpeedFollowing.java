package dev.eventchain.openscenario.storyboard.action;

import dev.eventchain.openscenario.storyboard.scene.Actor;
import dev.eventchain.openscenario.storyboard.scene.Longitudinal;
import dev.eventchain.openscenario.storyboard.scene.Scene;

/**
 * A speed that follows a target which may change; the way to it has a shape, as to one that does
 * not change.
 *
 * @param rate by which the speed changes at most, also when the target changes later, in m/s2
 * @param duration that of the way to the target, in s
 * @param elapsed the time since its begin, in s
 */
record SpeedFollowing(
    SpeedTarget target, Shape shape, double rate, double from, double duration, double elapsed)
    implements Longitudinal {

  @Override
  public Step step(Scene scene, Actor actor, double dt) {
    double after = elapsed + dt;
    double part = duration > 0 ? Math.min(1, after / duration) : 1;
    double to = actor.entity().performance().limited(target.in(scene));
    double before = actor.state().speed();
    double wanted = from + (to - from) * shape.value(part);
    double now = Math.max(before - rate * dt, Math.min(before + rate * dt, wanted));
    return new Step(
        (before + now) / 2 * dt,
        now,
        (now - before) / dt,
        new SpeedFollowing(target, shape, rate, from, duration, after),
        false);
  }
}
