package dev.eventchain.openscenario.storyboard;

import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.XmlElement;
import dev.eventchain.openscenario.document.ScenarioElement;
import dev.eventchain.openscenario.storyboard.tree.Change;
import dev.eventchain.openscenario.storyboard.world.Collisions;
import dev.eventchain.openscenario.storyboard.world.EntityState;
import dev.eventchain.openscenario.storyboard.world.RoadMap;
import dev.eventchain.openscenario.storyboard.world.RouteSides;
import dev.eventchain.openscenario.storyboard.world.StraightRoad;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/** Writes scenarios with two cars, and plays them. */
final class Scenarios {

  static final double STEP = 0.01;

  /** Two lanes in each direction, 3.5 m wide. */
  static final RoadMap ROAD = new StraightRoad("1", 2000, 2, 2, 3.5);

  private Scenarios() {}

  /** Returns a scenario. */
  static ScenarioElement scenario(String entities, String init, String stories) {
    return tree(
        "<OpenSCENARIO><RoadNetwork/><Entities>"
            + entities
            + "</Entities><Storyboard><Init><Actions>"
            + init
            + "</Actions></Init>"
            + stories
            + "</Storyboard></OpenSCENARIO>");
  }

  /** Returns the elements of a text in which no parameter or catalog is used. */
  static ScenarioElement tree(String text) {
    return tree(SourceText.of("test.xosc", text));
  }

  /** Returns likewise those of a file. */
  static ScenarioElement tree(SourceText text) {
    return element(XmlElement.parse(text, Rule.error("test.xml")));
  }

  private static ScenarioElement element(XmlElement written) {
    return new ScenarioElement(
        written,
        written.attributes(),
        written.children().stream().map(Scenarios::element).toList());
  }

  /** Returns a car of 4 x 2 m whose reference point is 1 m before its rear. */
  static String car(String name) {
    return """
        <ScenarioObject name="%s"><Vehicle name="car" vehicleCategory="car"><BoundingBox>
        <Center x="1" y="0" z="0.75"/><Dimensions length="4" width="2" height="1.5"/></BoundingBox>
        <Performance maxSpeed="60" maxAcceleration="5" maxDeceleration="10"/></Vehicle>
        </ScenarioObject>
        """
        .formatted(name);
  }

  /** Places an entity on a lane with a speed. */
  static String placed(String name, int lane, double s, double speed) {
    return privately(name, at(lane, s), speed("step", "time", 0, speed));
  }

  static String privately(String name, String... actions) {
    return "<Private entityRef='" + name + "'>" + String.join("", actions) + "</Private>";
  }

  static String at(int lane, double s) {
    return teleport(
        String.format(Locale.ROOT, "<LanePosition roadId='1' laneId='%d' s='%s'/>", lane, s));
  }

  static String teleport(String position) {
    return "<PrivateAction><TeleportAction><Position>"
        + position
        + "</Position></TeleportAction></PrivateAction>";
  }

  static String speed(String shape, String dimension, double value, double target) {
    return speed(shape, dimension, value, "<AbsoluteTargetSpeed value='" + target + "'/>");
  }

  static String speed(String shape, String dimension, double value, String target) {
    return longitudinal(
        "<SpeedAction><SpeedActionDynamics dynamicsShape='"
            + shape
            + "' dynamicsDimension='"
            + dimension
            + "' value='"
            + value
            + "'/><SpeedActionTarget>"
            + target
            + "</SpeedActionTarget></SpeedAction>");
  }

  static String longitudinal(String action) {
    return "<PrivateAction><LongitudinalAction>" + action + "</LongitudinalAction></PrivateAction>";
  }

  static String lateral(String action) {
    return "<PrivateAction><LateralAction>" + action + "</LateralAction></PrivateAction>";
  }

  /** Returns a story of one maneuver of an actor. */
  static String story(String actor, String... events) {
    return "<Story name='S'><Act name='A'><ManeuverGroup name='G' maximumExecutionCount='1'>"
        + "<Actors selectTriggeringEntities='false'>"
        + (actor.isEmpty() ? "" : "<EntityRef entityRef='" + actor + "'/>")
        + "</Actors><Maneuver name='M'>"
        + String.join("", events)
        + "</Maneuver></ManeuverGroup></Act></Story>";
  }

  static String event(String name, String action, String... conditions) {
    return event(name, "parallel", 1, action, conditions);
  }

  static String event(String name, String priority, int most, String action, String... conditions) {
    return "<Event name='"
        + name
        + "' priority='"
        + priority
        + "' maximumExecutionCount='"
        + most
        + "'><Action name='"
        + name
        + "Action'>"
        + action
        + "</Action>"
        + (conditions.length == 0
            ? ""
            : "<StartTrigger><ConditionGroup>"
                + String.join("", conditions)
                + "</ConditionGroup></StartTrigger>")
        + "</Event>";
  }

  static String when(String edge, double delay, String test) {
    return "<Condition name='c' conditionEdge='"
        + edge
        + "' delay='"
        + delay
        + "'>"
        + test
        + "</Condition>";
  }

  static String value(String condition) {
    return "<ByValueCondition>" + condition + "</ByValueCondition>";
  }

  static String timeIs(String rule, double value) {
    return value("<SimulationTimeCondition rule='" + rule + "' value='" + value + "'/>");
  }

  static String after(double time) {
    return when("none", 0, timeIs("greaterOrEqual", time));
  }

  static String ofEntity(String entity, String condition) {
    return "<ByEntityCondition><TriggeringEntities triggeringEntitiesRule='any'><EntityRef"
        + " entityRef='"
        + entity
        + "'/></TriggeringEntities><EntityCondition>"
        + condition
        + "</EntityCondition></ByEntityCondition>";
  }

  static String stop(double time) {
    return "<StopTrigger><ConditionGroup>" + after(time) + "</ConditionGroup></StopTrigger>";
  }

  static StoryboardRun run(ScenarioElement scenario) {
    return run(scenario, ROAD, Optional.empty());
  }

  static StoryboardRun run(
      ScenarioElement scenario, RoadMap roads, Optional<RouteSides> routeSides) {
    Map<String, String> parameters = new LinkedHashMap<>();
    scenario.child("ParameterDeclarations").stream()
        .flatMap(declarations -> declarations.children().stream())
        .forEach(each -> parameters.put(each.text("name"), each.text("value")));
    return StoryboardRun.start(scenario, parameters, roads, "Ego", routeSides);
  }

  /** Plays until a time, also beyond the end of the storyboard. */
  static StoryboardRun played(StoryboardRun run, double until) {
    while (run.time() < until - STEP / 2) {
      run.advance(STEP, Optional.empty(), Collisions.NONE);
    }
    return run;
  }

  static EntityState state(StoryboardRun run, String name) {
    return run.states().get(name);
  }

  /** Returns the changes as text: time, path, transition and state. */
  static List<String> changes(StoryboardRun run) {
    return run.changes().stream().map(Scenarios::text).toList();
  }

  private static String text(Change change) {
    return String.format(
        Locale.ROOT,
        "%.2f %s %s %s",
        change.time(),
        change.path(),
        change.transition(),
        change.state());
  }
}
