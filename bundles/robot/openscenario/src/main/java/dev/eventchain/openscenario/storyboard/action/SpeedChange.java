package dev.eventchain.openscenario.storyboard.action;

import dev.eventchain.openscenario.storyboard.scene.Actor;
import dev.eventchain.openscenario.storyboard.scene.Longitudinal;
import dev.eventchain.openscenario.storyboard.scene.Scene;

/**
 * A change of speed over time.
 *
 * @param elapsed the time since its begin, in s
 */
record SpeedChange(Transition speed, double elapsed) implements Longitudinal {

  /** Rest of a duration that is none, in s. */
  static final double NOTHING = 1e-9;

  @Override
  public Step step(Scene scene, Actor actor, double dt) {
    double after = elapsed + dt;
    return new Step(
        speed.integral(after) - speed.integral(elapsed),
        speed.value(after),
        speed.rate(after),
        new SpeedChange(speed, after),
        after >= speed.duration() - NOTHING);
  }
}
