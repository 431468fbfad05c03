package dev.eventchain.openscenario.storyboard.condition;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.condition.EntityTests.OfOne;
import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.world.Angles;
import dev.eventchain.openscenario.storyboard.world.EntityState;
import dev.eventchain.openscenario.storyboard.world.LanePoint;
import dev.eventchain.openscenario.storyboard.world.Pose;
import java.util.OptionalDouble;

/** Expressions on the orientation of an entity. */
final class AngleTests {

  private AngleTests() {}

  static OfOne read(ScenarioElement condition) {
    return switch (condition.name()) {
      case "AngleCondition" -> angle(condition);
      case "RelativeAngleCondition" -> relative(condition);
      case "RelativeClearanceCondition" -> Clearance.read(condition);
      default -> throw new IllegalArgumentException(condition.name() + " is not supported");
    };
  }

  private static OfOne angle(ScenarioElement condition) {
    String type = condition.text("angleType");
    String system = condition.optional("coordinateSystem").orElse("world");
    return (scene, actor) -> isAt(condition, angle(scene, actor.state(), type, system));
  }

  private static OfOne relative(ScenarioElement condition) {
    String type = condition.text("angleType");
    String system = condition.optional("coordinateSystem").orElse("world");
    String other = condition.text("entityRef");
    return (scene, actor) -> {
      OptionalDouble first = angle(scene, actor.state(), type, system);
      OptionalDouble second = angle(scene, scene.state(other), type, system);
      return scene.state(other).exists()
          && first.isPresent()
          && second.isPresent()
          && isAt(condition, OptionalDouble.of(first.getAsDouble() - second.getAsDouble()));
    };
  }

  private static boolean isAt(ScenarioElement condition, OptionalDouble angle) {
    return angle.isPresent()
        && Comparison.LESS_OR_EQUAL.holds(
            Angles.between(angle.getAsDouble(), condition.number("angle")),
            condition.number("angleTolerance"));
  }

  /** Returns an angle to the world, to the road, or to the direction in which a lane is driven. */
  private static OptionalDouble angle(Scene scene, EntityState state, String type, String system) {
    double absolute =
        switch (type) {
          case "heading" -> state.pose().heading();
          case "pitch" -> state.pose().pitch();
          default -> state.pose().roll();
        };
    if (!type.equals("heading") || !(system.equals("road") || system.equals("lane"))) {
      return OptionalDouble.of(absolute);
    }
    if (state.road().isEmpty()) {
      return OptionalDouble.empty();
    }
    LanePoint point = state.road().get();
    Pose road = scene.roads().pose(scene.roads().road(point));
    boolean against =
        system.equals("lane") && !scene.roads().goesAlongS(point.road(), point.s(), point.lane());
    return OptionalDouble.of(absolute - road.heading() - (against ? Math.PI : 0));
  }
}
