package dev.eventchain.openscenario.storyboard;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.action.Actions;
import dev.eventchain.openscenario.storyboard.check.Feature;
import dev.eventchain.openscenario.storyboard.condition.Trigger;
import dev.eventchain.openscenario.storyboard.position.Positions;
import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that the table of features says what is done. */
class FeatureTest {

  @Test
  void saysWhyForAllThatIsNotSupported() {
    for (Feature each : Feature.all().values()) {
      if (each.support() != Feature.Support.SUPPORTED) {
        assertFalse(each.reason().isBlank(), each.name());
      }
    }
    assertTrue(Feature.all().size() > 900);
    assertEquals(List.copyOf(Feature.all().keySet()).get(0), "AbsoluteSpeed");
  }

  @Test
  void attributesOfWhatIsRefusedAreRefused() {
    for (Feature each : Feature.all().values()) {
      Feature element = Feature.all().get(each.name().replaceFirst("@.*", ""));
      if (element.support() == Feature.Support.REFUSED) {
        assertEquals(Feature.Support.REFUSED, each.support(), each.name());
      }
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "WorldPosition",
        "RelativeWorldPosition",
        "RelativeObjectPosition",
        "RoadPosition",
        "RelativeRoadPosition",
        "LanePosition",
        "RelativeLanePosition",
        "RoutePosition",
        "GeoPosition",
        "TrajectoryPosition",
      })
  void knowsPositions(String name) {
    ScenarioElement position = Scenarios.tree("<Position><" + name + "/></Position>");
    // Some read their attributes only when they are looked for.
    assertAgrees(name, position, Positions::read);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "EndOfRoadCondition",
        "CollisionCondition",
        "OffroadCondition",
        "TimeHeadwayCondition",
        "TimeToCollisionCondition",
        "AccelerationCondition",
        "StandStillCondition",
        "SpeedCondition",
        "RelativeSpeedCondition",
        "TraveledDistanceCondition",
        "ReachPositionCondition",
        "DistanceCondition",
        "RelativeDistanceCondition",
        "RelativeClearanceCondition",
        "AngleCondition",
        "RelativeAngleCondition",
      })
  void knowsConditionsOnEntities(String name) {
    assertAgrees(
        name,
        trigger(
            "<ByEntityCondition><TriggeringEntities triggeringEntitiesRule='any'/>"
                + "<EntityCondition><"
                + name
                + "/></EntityCondition></ByEntityCondition>"),
        FeatureTest::read);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "ParameterCondition",
        "TimeOfDayCondition",
        "SimulationTimeCondition",
        "StoryboardElementStateCondition",
        "UserDefinedValueCondition",
        "TrafficSignalCondition",
        "TrafficSignalControllerCondition",
        "VariableCondition",
      })
  void knowsConditionsOnValues(String name) {
    assertAgrees(
        name, trigger("<ByValueCondition><" + name + "/></ByValueCondition>"), FeatureTest::read);
  }

  private static ScenarioElement trigger(String condition) {
    return Scenarios.tree(
        "<StartTrigger><ConditionGroup><Condition>"
            + condition
            + "</Condition></ConditionGroup></StartTrigger>");
  }

  private static void read(ScenarioElement trigger) {
    new Trigger(trigger, (type, reference) -> List.of());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "LongitudinalAction/SpeedAction",
        "LongitudinalAction/LongitudinalDistanceAction",
        "LongitudinalAction/SpeedProfileAction",
        "LateralAction/LaneChangeAction",
        "LateralAction/LaneOffsetAction",
        "LateralAction/LateralDistanceAction",
        "VisibilityAction",
        "SynchronizeAction",
        "ActivateControllerAction",
        "ControllerAction/AssignControllerAction",
        "ControllerAction/OverrideControllerValueAction",
        "ControllerAction/ActivateControllerAction",
        "TeleportAction",
        "RoutingAction/AssignRouteAction",
        "RoutingAction/FollowTrajectoryAction",
        "RoutingAction/AcquirePositionAction",
        "RoutingAction/RandomRouteAction",
        "AppearanceAction",
        "TrailerAction",
      })
  void knowsActionsOfEntities(String names) {
    assertAgrees(names, action("PrivateAction/" + names), Actions::read);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "EnvironmentAction",
        "EntityAction",
        "InfrastructureAction",
        "SetMonitorAction",
        "ParameterAction",
        "TrafficAction",
        "VariableAction",
      })
  void knowsActionsOfNone(String name) {
    assertAgrees(name, action("GlobalAction/" + name), Actions::read);
  }

  private static ScenarioElement action(String names) {
    String text = "";
    List<String> all = List.of(names.split("/", -1));
    for (int i = all.size() - 1; i >= 0; i--) {
      text = "<" + all.get(i) + ">" + text + "</" + all.get(i) + ">";
    }
    return Scenarios.tree(text);
  }

  /** What is known is read, or lacks what it needs. */
  private static void assertAgrees(
      String names, ScenarioElement element, Consumer<ScenarioElement> read) {
    String name = names.replaceFirst(".*/", "");
    String message = "";
    try {
      read.accept(element);
    } catch (IllegalArgumentException e) {
      message = e.getMessage();
    }
    boolean known = !message.contains("is not supported") && !message.contains("is no position");
    boolean refused = Feature.all().get(name).support() == Feature.Support.REFUSED;
    assertEquals(!refused, known, name + ": " + message);
  }
}
