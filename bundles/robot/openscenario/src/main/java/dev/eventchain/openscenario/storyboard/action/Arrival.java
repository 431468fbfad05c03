package dev.eventchain.openscenario.storyboard.action;

import dev.eventchain.openscenario.storyboard.position.Placement;
import dev.eventchain.openscenario.storyboard.scene.Actor;
import dev.eventchain.openscenario.storyboard.scene.LaneWay;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.scene.StraightOn;
import dev.eventchain.openscenario.storyboard.world.RoadPoint;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * A place where an entity is to arrive.
 *
 * @param tolerance the distance before it at which the entity is there, in m
 */
record Arrival(Placement place, double tolerance) {

  /** Returns the way to it along the entity's path or lane, or straight ahead, in m. */
  double distance(Scene scene, Actor actor) {
    if (actor.lateral() instanceof OnPath path) {
      OptionalDouble there = path.path().nearest(place.pose());
      if (there.isPresent()) {
        return there.getAsDouble() - path.at();
      }
    }
    Optional<LaneWay> way = LaneWay.of(scene, actor.state());
    if (way.isPresent() && place.road().isPresent()) {
      RoadPoint from = scene.roads().road(way.get().point());
      OptionalDouble along = scene.roads().along(from, scene.roads().road(place.road().get()));
      if (along.isPresent() && actor.lateral() != StraightOn.STRAIGHT_ON) {
        return way.get().alongS() ? along.getAsDouble() : -along.getAsDouble();
      }
    }
    return actor.state().pose().ahead(place.pose());
  }
}
