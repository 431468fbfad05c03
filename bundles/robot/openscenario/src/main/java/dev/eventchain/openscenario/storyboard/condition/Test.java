package dev.eventchain.openscenario.storyboard.condition;

import dev.eventchain.openscenario.storyboard.scene.Scene;

/** A logical expression of a condition, without its edge and its delay. */
@FunctionalInterface
interface Test {

  Outcome in(Scene scene);
}
