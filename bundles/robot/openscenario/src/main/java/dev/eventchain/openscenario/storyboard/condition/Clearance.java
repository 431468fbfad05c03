package dev.eventchain.openscenario.storyboard.condition;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.condition.EntityTests.OfOne;
import dev.eventchain.openscenario.storyboard.position.Body;
import dev.eventchain.openscenario.storyboard.position.Measure;
import dev.eventchain.openscenario.storyboard.scene.Actor;
import dev.eventchain.openscenario.storyboard.scene.LaneWay;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.world.LanePoint;
import dev.eventchain.openscenario.storyboard.world.RoadPoint;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Test that no other entity is near on some lanes. Lanes are counted from the entity's own,
 * positive to its left; an entity is on the lane of its reference point.
 */
final class Clearance {

  private final ScenarioElement written;
  private final List<String> others;
  private final double forward;
  private final double backward;
  private final Measure measure;

  private Clearance(ScenarioElement written) {
    this.written = written;
    others = written.children("EntityRef").stream().map(each -> each.text("entityRef")).toList();
    forward = written.number("distanceForward", 0);
    backward = written.number("distanceBackward", 0);
    measure = new Measure(Measure.Kind.LONGITUDINAL, Measure.Frame.ROAD, written.flag("freeSpace"));
  }

  static OfOne read(ScenarioElement condition) {
    return new Clearance(condition)::isClear;
  }

  private boolean isClear(Scene scene, Actor actor) {
    Optional<LaneWay> own = LaneWay.of(scene, actor.state());
    List<String> named =
        others.stream().flatMap(each -> scene.entities().named(each).stream()).toList();
    return own.isPresent()
        && scene.actors().stream()
            .filter(each -> each != actor && each.state().exists())
            .filter(each -> others.isEmpty() || named.contains(each.entity().name()))
            .noneMatch(each -> isNear(scene, actor, own.get(), each));
  }

  private boolean isNear(Scene scene, Actor actor, LaneWay own, Actor other) {
    OptionalDouble gap = measure.signed(scene, Body.of(actor), Body.of(other));
    return gap.isPresent()
        && gap.getAsDouble() <= forward
        && gap.getAsDouble() >= -backward
        && isOnLanes(scene, own, other.state().road().orElseThrow());
  }

  private boolean isOnLanes(Scene scene, LaneWay own, LanePoint other) {
    String road = other.road();
    boolean opposite =
        scene.roads().goesAlongS(road, other.s(), other.lane())
            != scene.roads().goesAlongS(own.point().road(), own.point().s(), own.point().lane());
    if (opposite && !written.flag("oppositeLanes")) {
      return false;
    }
    // The lanes of the other's road, from the one that continues the own by its place.
    List<Integer> lanes = scene.roads().lanes(road, other.s());
    RoadPoint beside = new RoadPoint(road, other.s(), scene.roads().road(own.point()).t());
    int from = lanes.indexOf(scene.roads().lane(beside).lane());
    int to = lanes.indexOf(other.lane());
    int left = own.alongS() ? from - to : to - from;
    List<ScenarioElement> ranges = written.children("RelativeLaneRange");
    return ranges.isEmpty()
        || ranges.stream()
            .anyMatch(
                each ->
                    left >= each.number("from", Double.NEGATIVE_INFINITY)
                        && left <= each.number("to", Double.POSITIVE_INFINITY));
  }
}
