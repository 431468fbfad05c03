package dev.eventchain.openscenario.storyboard.action;

import dev.eventchain.openscenario.storyboard.position.Path;
import dev.eventchain.openscenario.storyboard.scene.Actor;
import dev.eventchain.openscenario.storyboard.scene.Lateral;
import dev.eventchain.openscenario.storyboard.scene.Longitudinal;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.world.EntityState;
import dev.eventchain.openscenario.storyboard.world.Pose;

/**
 * Follows a path. Beyond its end it goes straight on.
 *
 * @param at the way along it so far, in m
 * @param again whether it begins again at its end
 */
record OnPath(Path path, double at, boolean again) implements Lateral {

  /** Rest of a way that is none, in m. */
  private static final double NOTHING = 1e-9;

  @Override
  public Step step(Scene scene, Actor actor, Longitudinal.Step moved, double dt) {
    double way = at + moved.distance();
    boolean over = way >= path.length() - NOTHING;
    if (over && again) {
      way %= path.length();
    }
    double within = Math.max(0, Math.min(path.length(), way));
    Pose pose = path.pose(within).moved(way - within, 0);
    return new Step(
        pose,
        scene.roads().find(pose),
        pose.heading(),
        0,
        false,
        new OnPath(path, way, again),
        over && !again);
  }

  @Override
  public Lateral from(Scene scene, EntityState seen) {
    return new OnPath(path, path.nearest(seen.pose()).orElse(at), again);
  }

  @Override
  public boolean isLine() {
    return true;
  }
}
