package dev.eventchain.openscenario.storyboard.action;

import dev.eventchain.openscenario.storyboard.scene.Actor;
import dev.eventchain.openscenario.storyboard.scene.KeepLane;
import dev.eventchain.openscenario.storyboard.scene.LaneWay;
import dev.eventchain.openscenario.storyboard.scene.Lateral;
import dev.eventchain.openscenario.storyboard.scene.Longitudinal;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.world.EntityState;
import dev.eventchain.openscenario.storyboard.world.LanePoint;
import dev.eventchain.openscenario.storyboard.world.Pose;
import java.util.Optional;

/**
 * A motion to an offset of a lane.
 *
 * @param way the place as seen from that lane
 * @param to the offset, to the left along s, in m
 * @param from the offset at the begin
 * @param extent how long it takes, in s, or in m along the lane
 * @param byWay whether that is in m
 * @param done how much of that is over
 * @param lasts whether it goes on when the offset is reached
 */
record LaneShift(
    LaneWay way,
    Shape shape,
    double from,
    Target to,
    double extent,
    boolean byWay,
    double done,
    boolean lasts)
    implements Lateral {

  /** An offset that may change. */
  @FunctionalInterface
  interface Target {
    double in(Scene scene);
  }

  @Override
  public Step step(Scene scene, Actor actor, Longitudinal.Step moved, double dt) {
    Optional<LaneWay> there = way.moved(scene, moved.distance(), actor.route());
    LaneWay now = there.orElse(way);
    double after = done + (byWay ? Math.abs(moved.distance()) : dt);
    boolean reached = after >= extent - SpeedChange.NOTHING;
    double part = reached ? 1 : after / extent;
    double offset = from + (to.in(scene) - from) * shape.value(part);
    double rate = reached ? 0 : (to.in(scene) - from) * shape.slope(part) / extent;
    double perSecond = byWay ? rate * Math.abs(moved.speed()) : rate;
    LaneWay shifted = now.withOffset(offset);
    Pose pose = shifted.pose(scene);
    LanePoint road = scene.roads().lane(scene.roads().road(shifted.point()));
    return new Step(
        pose,
        Optional.of(road),
        pose.heading(),
        now.alongS() ? perSecond : -perSecond,
        there.isEmpty(),
        new LaneShift(shifted, shape, from, to, extent, byWay, after, lasts),
        reached && !lasts);
  }

  @Override
  public Lateral from(Scene scene, EntityState seen) {
    Optional<LaneWay> there =
        LaneWay.of(scene, seen)
            .filter(each -> each.point().road().equals(way.point().road()))
            .map(each -> each.onLane(scene, way.point().lane()));
    return new LaneShift(there.orElse(way), shape, from, to, extent, byWay, done, lasts);
  }

  @Override
  public Lateral rest(Scene scene, EntityState state) {
    return new KeepLane(way, 0, false);
  }
}
