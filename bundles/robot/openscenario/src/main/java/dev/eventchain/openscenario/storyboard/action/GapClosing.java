package dev.eventchain.openscenario.storyboard.action;

import dev.eventchain.openscenario.storyboard.scene.Actor;
import dev.eventchain.openscenario.storyboard.scene.Longitudinal;
import dev.eventchain.openscenario.storyboard.scene.Scene;

/**
 * Closes a gap as fast as limits allow: it speeds up, and slows down so that both are equally fast
 * when the gap is what it should be.
 */
record GapClosing(LongitudinalDistance gap, boolean trailing, Limits limits, boolean continuous)
    implements Longitudinal {

  /** Rest of a gap that is none, in m. */
  private static final double NEAR = 1e-3;

  /** Difference of speeds that is none when the gap is closed, in m/s. */
  private static final double AS_FAST = 0.1;

  @Override
  public Step step(Scene scene, Actor actor, double dt) {
    Limits most = limits.within(actor.entity().performance());
    double before = actor.state().speed();
    double other = gap.reference(scene).speed();
    double error = gap.error(scene, actor, gap.referenceAfter(scene, dt), trailing) - other * dt;
    double wanted = other + faster(error, most, dt, gap.time());
    double lowest = before - most.deceleration() * dt;
    double highest = before + most.acceleration() * dt;
    double speed = Math.max(lowest, Math.min(highest, wanted));
    double limited = Math.max(0, Math.min(most.speed(), speed));
    double distance = (before + limited) / 2 * dt;
    double rest = error + other * dt - distance;
    boolean reached = Math.abs(rest) <= NEAR && Math.abs(limited - other) <= AS_FAST;
    return reached && !continuous
        ? new Step(distance, other, 0, this, true)
        : new Step(distance, limited, (limited - before) / dt, this, false);
  }

  /**
   * Returns how much faster one may be so far from the aim, if in each step the speed changes by as
   * much as the limit allows.
   *
   * @param time by how much the aim changes with the speed, in s
   */
  private static double faster(double error, Limits most, double dt, double time) {
    double limit = error > 0 ? most.deceleration() : most.acceleration();
    double step = limit * dt / 2;
    double stoppable =
        Double.isInfinite(limit)
            ? Double.POSITIVE_INFINITY
            : Math.sqrt(step * step + 2 * limit * Math.abs(error)) - step;
    return Math.signum(error) * Math.min(Math.abs(error) / (dt + time), stoppable);
  }
}
