package dev.eventchain.openscenario.storyboard.action;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.scene.Actor;
import dev.eventchain.openscenario.storyboard.scene.LaneWay;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.scene.Task;
import dev.eventchain.openscenario.storyboard.world.ControlDomain;
import dev.eventchain.openscenario.storyboard.world.EntityState;
import dev.eventchain.openscenario.storyboard.world.LanePoint;
import dev.eventchain.openscenario.storyboard.world.StoryboardRules;
import java.util.List;
import java.util.Optional;

/** Changes of the lane and of the offset to it. */
final class LateralActions {

  private LateralActions() {}

  static PrivateAction laneChange(ScenarioElement action) {
    Dynamics dynamics = Dynamics.of(action.required("LaneChangeActionDynamics"));
    ScenarioElement target = action.required("LaneChangeTarget").choice();
    double offset = action.number("targetLaneOffset", 0);
    return (scene, actor) -> {
      LaneWay own = way(scene, actor, action);
      LaneWay way = own.onLane(scene, lane(scene, own, target));
      double from = way.point().offset();
      boolean byWay = dynamics.dimension().equals("distance");
      double extent = byWay ? dynamics.value() : dynamics.duration(offset - from);
      return start(
          scene,
          actor,
          new LaneShift(
              way,
              dynamics.shape(),
              from,
              at -> offset,
              dynamics.atOnce() ? 0 : extent,
              byWay,
              0,
              false));
    };
  }

  /** Returns the number of the target lane, on the road on which the entity is. */
  private static int lane(Scene scene, LaneWay own, ScenarioElement target) {
    Optional<Integer> lane;
    if (target.name().equals("AbsoluteTargetLane")) {
      lane = parsed(target.text("value"));
    } else {
      Optional<LaneWay> other = LaneWay.of(scene, scene.state(target.text("entityRef")));
      lane = other.flatMap(each -> each.beside(scene, target.integer("value")));
    }
    List<Integer> lanes = scene.roads().lanes(own.point().road(), own.point().s());
    return lane.filter(lanes::contains)
        .orElseThrow(
            () ->
                StoryboardRules.failure(
                    StoryboardRules.NO_PLACE,
                    "There is no such lane on road '"
                        + own.point().road()
                        + "', which has "
                        + lanes
                        + ".",
                    target.location("value"),
                    "Correct the value, or use the road network that it was written for."));
  }

  private static Optional<Integer> parsed(String lane) {
    try {
      return Optional.of(Integer.valueOf(lane));
    } catch (NumberFormatException e) {
      return Optional.empty();
    }
  }

  static PrivateAction laneOffset(ScenarioElement action) {
    ScenarioElement dynamics = action.required("LaneOffsetActionDynamics");
    Shape shape = Shape.of(dynamics.text("dynamicsShape"));
    double acceleration = dynamics.number("maxLateralAcc", Double.POSITIVE_INFINITY);
    boolean continuous = action.flag("continuous");
    ScenarioElement target = action.required("LaneOffsetTarget").choice();
    return (scene, actor) -> {
      LaneWay way = way(scene, actor, action);
      LaneShift.Target to = offset(scene, target, continuous);
      double from = way.point().offset();
      double change = Math.abs(to.in(scene) - from);
      double duration =
          shape == Shape.STEP ? 0 : Math.sqrt(shape.sharpest() * change / acceleration);
      return start(
          scene, actor, new LaneShift(way, shape, from, to, duration, false, 0, continuous));
    };
  }

  /** Returns a target that moves with the entity that it is relative to if it is continuous. */
  private static LaneShift.Target offset(Scene scene, ScenarioElement target, boolean continuous) {
    double value = target.number("value");
    if (target.name().equals("AbsoluteTargetLaneOffset")) {
      return at -> value;
    }
    String other = target.text("entityRef");
    LaneShift.Target relative =
        at -> at.state(other).road().map(LanePoint::offset).orElse(0.0) + value;
    double now = relative.in(scene);
    return continuous ? relative : at -> now;
  }

  /** Returns where an entity is that moves in lanes. */
  static LaneWay way(Scene scene, Actor actor, ScenarioElement action) {
    return LaneWay.of(scene, actor.state())
        .orElseThrow(
            () ->
                StoryboardRules.failure(
                    StoryboardRules.NO_PLACE,
                    "'"
                        + actor.entity().name()
                        + "' is on no road when its "
                        + action.name()
                        + " begins.",
                    action.location(),
                    "Place it on a lane, or use a FollowTrajectoryAction."));
  }

  /** Starts a shift; one that takes no time happens at once. */
  static Optional<Task> start(Scene scene, Actor actor, LaneShift shift) {
    Task task = new Task(actor.entity().name());
    if (!(shift.extent() > 0) && !actor.decides(ControlDomain.LATERAL)) {
      LaneWay there = shift.way().withOffset(shift.to().in(scene));
      EntityState before = actor.state();
      actor.place(
          scene,
          EntityState.along(
                  there.pose(scene),
                  before.speed(),
                  Optional.of(scene.roads().lane(scene.roads().road(there.point()))))
              .withVisibility(before.visibility()));
    }
    if (!(shift.extent() > 0) && !shift.lasts()) {
      return Optional.empty();
    }
    actor.steer(scene, task, shift);
    return Optional.of(task);
  }
}
