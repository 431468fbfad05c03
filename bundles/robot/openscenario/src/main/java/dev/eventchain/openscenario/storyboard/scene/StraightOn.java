package dev.eventchain.openscenario.storyboard.scene;

import dev.eventchain.openscenario.storyboard.world.EntityState;
import dev.eventchain.openscenario.storyboard.world.Pose;

/** Goes straight on, whatever roads there are. */
public enum StraightOn implements Lateral {
  STRAIGHT_ON;

  @Override
  public Step step(Scene scene, Actor actor, Longitudinal.Step moved, double dt) {
    Pose pose = actor.state().pose().moved(moved.distance(), 0);
    return new Step(pose, scene.roads().find(pose), pose.heading(), 0, false, this, false);
  }

  @Override
  public Lateral from(Scene scene, EntityState seen) {
    return this;
  }

  @Override
  public boolean isLine() {
    return true;
  }
}
