package dev.eventchain.openscenario.storyboard.action;

import dev.eventchain.openscenario.storyboard.scene.Actor;
import dev.eventchain.openscenario.storyboard.scene.Longitudinal;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.world.EntityState;

/** Holds a gap as if the two were coupled. */
record GapHolding(LongitudinalDistance gap, boolean trailing) implements Longitudinal {

  @Override
  public Step step(Scene scene, Actor actor, double dt) {
    EntityState other = gap.reference(scene);
    return new Step(
        gap.error(scene, actor, gap.referenceAfter(scene, dt), trailing),
        other.speed() + other.acceleration() * dt,
        other.acceleration(),
        this,
        false);
  }
}
