package dev.eventchain.openscenario.storyboard.action;

import dev.eventchain.openscenario.storyboard.scene.Actor;
import dev.eventchain.openscenario.storyboard.scene.KeepLane;
import dev.eventchain.openscenario.storyboard.scene.LaneWay;
import dev.eventchain.openscenario.storyboard.scene.Lateral;
import dev.eventchain.openscenario.storyboard.scene.Longitudinal;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.world.EntityState;
import dev.eventchain.openscenario.storyboard.world.RoadPoint;
import java.util.OptionalDouble;

/** Follows the lanes until it is beside a point of a road. */
record LaneTo(KeepLane lane, RoadPoint aim) implements Lateral {

  @Override
  public Step step(Scene scene, Actor actor, Longitudinal.Step moved, double dt) {
    Step step = lane.step(scene, actor, moved, dt);
    Lateral next = step.next() instanceof KeepLane kept ? new LaneTo(kept, aim) : step.next();
    return new Step(
        step.pose(),
        step.road(),
        step.course(),
        step.across(),
        step.atEnd(),
        next,
        isThere(scene, step));
  }

  private boolean isThere(Scene scene, Step step) {
    if (step.road().isEmpty() || !(step.next() instanceof KeepLane kept)) {
      return false;
    }
    LaneWay way = kept.way();
    OptionalDouble along = scene.roads().along(scene.roads().road(way.point()), aim);
    return along.isPresent()
        && (way.alongS() ? along.getAsDouble() <= 0 : along.getAsDouble() >= 0);
  }

  @Override
  public Lateral from(Scene scene, EntityState seen) {
    return lane.from(scene, seen) instanceof KeepLane kept ? new LaneTo(kept, aim) : this;
  }
}
