package dev.eventchain.openscenario.storyboard;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.action.Actions;
import dev.eventchain.openscenario.storyboard.check.Feature;
import dev.eventchain.openscenario.storyboard.condition.Trigger;
import dev.eventchain.openscenario.storyboard.position.Positions;
import dev.eventchain.openscenario.vocabulary.AttributeType;
import dev.eventchain.openscenario.vocabulary.ElementType;
import dev.eventchain.openscenario.vocabulary.Vocabulary;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
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
  }

  /** Of each version: an attribute that has words has a row for each of them instead of its own. */
  @Test
  void hasARowForAllOfTheStandardAndForNothingElse() {
    Set<String> standard = new TreeSet<>();
    addNames("OpenSCENARIO", Vocabulary.standard().root(), standard);
    for (ElementType parent : Vocabulary.standard().elements()) {
      parent
          .children()
          .forEach((name, type) -> addNames(name, Vocabulary.standard().element(type), standard));
    }
    assertEquals(List.copyOf(standard), List.copyOf(Feature.all().keySet()));
  }

  private static void addNames(String element, ElementType type, Set<String> names) {
    names.add(element);
    for (AttributeType each : type.attributes().values()) {
      String attribute = element + "@" + each.name();
      Vocabulary.standard()
          .enumeration(each.type())
          .ifPresentOrElse(
              words -> words.words().forEach(word -> names.add(attribute + "=" + word)),
              () -> names.add(attribute));
    }
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

  /** A known feature is read, or lacks what it needs. */
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
