package dev.eventchain.openscenario.storyboard;

import static dev.eventchain.openscenario.storyboard.Scenarios.STEP;
import static dev.eventchain.openscenario.storyboard.Scenarios.after;
import static dev.eventchain.openscenario.storyboard.Scenarios.car;
import static dev.eventchain.openscenario.storyboard.Scenarios.changes;
import static dev.eventchain.openscenario.storyboard.Scenarios.event;
import static dev.eventchain.openscenario.storyboard.Scenarios.ofEntity;
import static dev.eventchain.openscenario.storyboard.Scenarios.placed;
import static dev.eventchain.openscenario.storyboard.Scenarios.played;
import static dev.eventchain.openscenario.storyboard.Scenarios.privately;
import static dev.eventchain.openscenario.storyboard.Scenarios.scenario;
import static dev.eventchain.openscenario.storyboard.Scenarios.speed;
import static dev.eventchain.openscenario.storyboard.Scenarios.story;
import static dev.eventchain.openscenario.storyboard.Scenarios.teleport;
import static dev.eventchain.openscenario.storyboard.Scenarios.tree;
import static dev.eventchain.openscenario.storyboard.Scenarios.value;
import static dev.eventchain.openscenario.storyboard.Scenarios.when;
import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.openscenario.storyboard.world.Collisions;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Tests what conditions say. The ego drives at 10 m/s from s = 100 m, another one before it at 4
 * m/s from s = 150 m. Fronts are 3 m before, and rears 1 m behind the reference points. On the lane
 * to the right, someone is 20 m behind, and one comes towards them on the lane to the left, 60 m
 * ahead.
 */
class ConditionTest {

  private static final String INIT =
      placed("Ego", -1, 100, 10)
          + placed("Other", -1, 150, 4)
          + placed("Beside", -2, 80, 12)
          + placed("Oncoming", 1, 160, 6);

  private static final String CARS = car("Ego") + car("Other") + car("Beside") + car("Oncoming");

  private static StoryboardRun run(String action, String condition) {
    return Scenarios.run(
        scenario(
            CARS,
            INIT,
            story(
                    "Ego",
                    event("A", action, after(0)),
                    event("E", "<UserDefinedAction/>", condition))
                + Scenarios.stop(100)));
  }

  private static boolean holds(StoryboardRun run) {
    return changes(run).stream().anyMatch(each -> each.contains("/E START"));
  }

  private static boolean holds(String condition) {
    return holds(run("<UserDefinedAction/>", when("none", 0, condition)));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "<SpeedCondition rule='equalTo' value='10'/>",
        "<SpeedCondition rule='greaterOrEqual' value='10'/>",
        "<SpeedCondition rule='lessOrEqual' value='10'/>",
        "<SpeedCondition rule='notEqualTo' value='11'/>",
        "<SpeedCondition rule='greaterThan' value='9' direction='longitudinal'/>",
        "<SpeedCondition rule='equalTo' value='0' direction='lateral'/>",
        "<RelativeSpeedCondition entityRef='Other' rule='equalTo' value='6'/>",
        "<RelativeSpeedCondition entityRef='Other' rule='equalTo' value='6'"
            + " direction='longitudinal'/>",
        "<AccelerationCondition rule='equalTo' value='0'/>",
        "<TraveledDistanceCondition value='0'/>",
        "<ReachPositionCondition tolerance='2'><Position><LanePosition roadId='1' laneId='-1'"
            + " s='102'/></Position></ReachPositionCondition>",
        "<DistanceCondition freespace='true' rule='equalTo' value='0'><Position>"
            + "<LanePosition roadId='1' laneId='-1' s='101'/></Position></DistanceCondition>",
        "<DistanceCondition freespace='false' rule='equalTo' value='50'><Position>"
            + "<LanePosition roadId='1' laneId='-1' s='150'/></Position></DistanceCondition>",
        "<DistanceCondition freespace='true' rule='equalTo' value='47'><Position>"
            + "<LanePosition roadId='1' laneId='-1' s='150'/></Position></DistanceCondition>",
        "<DistanceCondition freespace='false' alongRoute='true' rule='equalTo' value='50'>"
            + "<Position><LanePosition roadId='1' laneId='-2' s='150'/></Position>"
            + "</DistanceCondition>",
        "<RelativeDistanceCondition entityRef='Other' freespace='false' rule='equalTo' value='50'"
            + " relativeDistanceType='longitudinal'/>",
        "<RelativeDistanceCondition entityRef='Other' freespace='true' rule='equalTo' value='46'"
            + " relativeDistanceType='longitudinal'/>",
        "<RelativeDistanceCondition entityRef='Other' freespace='true' rule='equalTo' value='46'"
            + " relativeDistanceType='euclidianDistance'/>",
        "<RelativeDistanceCondition entityRef='Other' freespace='true' rule='equalTo' value='46'"
            + " relativeDistanceType='longitudinal' coordinateSystem='lane'/>",
        "<RelativeDistanceCondition entityRef='Beside' freespace='true' rule='equalTo' value='16'"
            + " relativeDistanceType='longitudinal' coordinateSystem='road'/>",
        "<RelativeDistanceCondition entityRef='Beside' freespace='false' rule='equalTo'"
            + " value='3.5' relativeDistanceType='lateral' coordinateSystem='lane'/>",
        "<RelativeDistanceCondition entityRef='Beside' freespace='true' rule='equalTo' value='1.5'"
            + " relativeDistanceType='lateral' coordinateSystem='entity'/>",
        "<RelativeDistanceCondition entityRef='Oncoming' freespace='true' rule='equalTo'"
            + " value='54' relativeDistanceType='longitudinal' coordinateSystem='road'/>",
        "<RelativeDistanceCondition entityRef='Oncoming' freespace='true' rule='equalTo'"
            + " value='1.5' relativeDistanceType='lateral' coordinateSystem='world'/>",
        "<TimeHeadwayCondition entityRef='Other' freespace='false' rule='equalTo' value='5'"
            + " relativeDistanceType='longitudinal'/>",
        "<TimeHeadwayCondition entityRef='Other' freespace='true' rule='equalTo' value='4.6'/>",
        "<AngleCondition angleType='heading' angle='0.1' angleTolerance='0.1'/>",
        "<AngleCondition angleType='heading' angle='0' angleTolerance='0' coordinateSystem='lane'"
            + "/>",
        "<AngleCondition angleType='roll' angle='0' angleTolerance='0'/>",
        "<RelativeAngleCondition entityRef='Oncoming' angleType='heading' angle='3.14'"
            + " angleTolerance='0.01'/>",
        "<RelativeAngleCondition entityRef='Oncoming' angleType='heading' angle='0'"
            + " angleTolerance='0.01' coordinateSystem='lane'/>",
        "<RelativeClearanceCondition oppositeLanes='false' freeSpace='false' distanceForward='49'"
            + " distanceBackward='19'/>",
        "<RelativeClearanceCondition oppositeLanes='true' freeSpace='true' distanceForward='45'"
            + " distanceBackward='15'/>",
        "<RelativeClearanceCondition oppositeLanes='false' freeSpace='false' distanceForward='99'>"
            + "<RelativeLaneRange from='1' to='1'/></RelativeClearanceCondition>",
        "<RelativeClearanceCondition oppositeLanes='true' freeSpace='false' distanceForward='99'>"
            + "<EntityRef entityRef='Beside'/></RelativeClearanceCondition>",
      })
  void holdsNow(String condition) {
    assertEquals(true, holds(ofEntity("Ego", condition)));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "<SpeedCondition rule='greaterThan' value='10'/>",
        "<SpeedCondition rule='lessThan' value='10'/>",
        "<StandStillCondition duration='0'/>",
        "<OffroadCondition duration='0'/>",
        "<EndOfRoadCondition duration='0'/>",
        "<CollisionCondition><EntityRef entityRef='Other'/></CollisionCondition>",
        "<CollisionCondition><ByType type='vehicle'/></CollisionCondition>",
        "<TraveledDistanceCondition value='0.1'/>",
        "<ReachPositionCondition tolerance='1.9'><Position><LanePosition roadId='1' laneId='-1'"
            + " s='102'/></Position></ReachPositionCondition>",
        "<TimeToCollisionCondition freespace='true' rule='lessThan' value='1000'>"
            + "<TimeToCollisionConditionTarget><Position><LanePosition roadId='1' laneId='-1' s='50'/>"
            + "</Position></TimeToCollisionConditionTarget></TimeToCollisionCondition>",
        "<RelativeClearanceCondition oppositeLanes='false' freeSpace='false' distanceForward='50'"
            + "/>",
        "<RelativeClearanceCondition oppositeLanes='false' freeSpace='true' distanceForward='46'"
            + "/>",
        "<RelativeClearanceCondition oppositeLanes='false' freeSpace='true' distanceBackward='16'"
            + "><RelativeLaneRange to='-1'/></RelativeClearanceCondition>",
        "<RelativeClearanceCondition oppositeLanes='true' freeSpace='false' distanceForward='60'>"
            + "<RelativeLaneRange from='1'/></RelativeClearanceCondition>",
      })
  void doesNotHold(String condition) {
    assertEquals(false, holds(ofEntity("Ego", condition)));
  }

  @ParameterizedTest
  @CsvSource({
    // 50 m between reference points and 46 m between boxes, closed at 6 m/s
    "false, '', 8.333333",
    "true, '', 7.666667",
    "true, longitudinal, 7.666667",
  })
  void theTimeToCollisionIsThatAtTheseVelocities(boolean freespace, String type, double time) {
    String kind = type.isEmpty() ? "" : "relativeDistanceType='longitudinal'";
    for (double off : new double[] {-1e-4, 1e-4}) {
      for (String system : new String[] {"entity", "road"}) {
        String condition =
            "<TimeToCollisionCondition freespace='"
                + freespace
                + "' rule='lessThan' value='"
                + (time + off)
                + "' coordinateSystem='"
                + system
                + "' "
                + kind
                + "><TimeToCollisionConditionTarget><EntityRef entityRef='Other'/>"
                + "</TimeToCollisionConditionTarget></TimeToCollisionCondition>";
        assertEquals(off > 0, holds(ofEntity("Ego", condition)), condition);
      }
    }
  }

  @Test
  void durationsAndWaysCountFromTheirBegin() {
    String stops = speed("linear", "time", 1, 0);
    StoryboardRun standing =
        played(
            run(stops, when("none", 0, ofEntity("Ego", "<StandStillCondition duration='0.5'/>"))),
            2);
    assertEquals(1.5, started(standing), 0.011);
    StoryboardRun way =
        played(
            run(
                stops,
                when("none", 0, ofEntity("Ego", "<TraveledDistanceCondition value='3.2'/>"))),
            2);
    // 10 t - 5 t^2 = 3.2
    assertEquals(0.4, started(way), 1e-9);
    StoryboardRun braking =
        played(
            run(
                stops,
                when(
                    "rising",
                    0,
                    ofEntity(
                        "Ego",
                        "<AccelerationCondition direction='longitudinal' rule='lessThan'"
                            + " value='-9.99'/>"))),
            2);
    assertEquals(0.01, started(braking), 1e-9);
  }

  @Test
  void seesTheEndOfTheRoadAndWhatIsBesideIt() {
    String init =
        privately(
                "Ego",
                teleport("<LanePosition roadId='1' laneId='-1' s='1990'/>"),
                speed("step", "time", 0, 10))
            + privately("Other", teleport("<WorldPosition x='5' y='100'/>"));
    StoryboardRun run =
        Scenarios.run(
            scenario(
                car("Ego") + car("Other"),
                init,
                story(
                        "Ego",
                        event(
                            "E",
                            "<UserDefinedAction/>",
                            when("none", 0, ofEntity("Ego", "<EndOfRoadCondition duration='1'/>"))),
                        event(
                            "F",
                            "<UserDefinedAction/>",
                            when("none", 0, ofEntity("Other", "<OffroadCondition duration='1'/>"))))
                    + Scenarios.stop(100)));
    played(run, 4);
    assertEquals(2.01, started(run), 0.011);
    assertEquals(
        1, changes(run).stream().filter(each -> each.startsWith("1.00 S/A/G/M/F START")).count());
    assertEquals(2000, Scenarios.state(run, "Ego").pose().x(), 0.2);
    assertEquals(0, Scenarios.state(run, "Ego").speed());
  }

  @Test
  void seesContacts() {
    for (String target :
        new String[] {"<EntityRef entityRef='Other'/>", "<ByType type='vehicle'/>"}) {
      String condition = "<CollisionCondition>" + target + "</CollisionCondition>";
      StoryboardRun run = run("<UserDefinedAction/>", when("none", 0, ofEntity("Ego", condition)));
      Collisions contact = (first, second) -> second.equals("Other") || first.equals("Other");
      run.advance(STEP, Optional.empty(), Collisions.NONE);
      assertEquals(false, holds(run));
      run.advance(STEP, Optional.empty(), contact);
      assertEquals(true, holds(run));
    }
  }

  @Test
  void asksOneOrAllOfTheTriggeringEntities() {
    String both =
        ofEntity("Ego", "<SpeedCondition rule='greaterThan' value='5'/>")
            .replace(
                "<EntityRef entityRef='Ego'/>",
                "<EntityRef entityRef='Ego'/><EntityRef entityRef='Other'/>");
    assertEquals(true, holds(both));
    assertEquals(false, holds(both.replace("'any'", "'all'")));
    assertEquals(true, holds(both.replace("'any'", "'all'").replace("value='5'", "value='3'")));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<VariableCondition variableRef='n' rule='greaterThan' value='9'/> | true",
        "<VariableCondition variableRef='n' rule='lessThan' value='9'/> | false",
        "<ParameterCondition parameterRef='p' rule='equalTo' value='on'/> | true",
        "<ParameterCondition parameterRef='p' rule='notEqualTo' value='on'/> | false",
        "<TimeOfDayCondition dateTime='2026-01-01T12:00:00Z' rule='greaterOrEqual'/> | true",
        "<TimeOfDayCondition dateTime='2026-01-01T12:00:01Z' rule='greaterOrEqual'/> | false",
        "<TrafficSignalCondition name='12' state='red'/> | true",
        "<TrafficSignalCondition name='12' state='green'/> | false",
        "<TrafficSignalCondition name='13' state='red'/> | false",
        "<TrafficSignalControllerCondition trafficSignalControllerRef='c' phase='stop'/> | true",
        "<TrafficSignalControllerCondition trafficSignalControllerRef='c' phase='go'/> | false",
        "<SimulationTimeCondition rule='equalTo' value='0'/> | true",
      })
  void asksForValues(String condition, boolean expected) {
    assertEquals(expected, holds(valued(value(condition), "")));
  }

  private static StoryboardRun valued(String condition, String more) {
    String text =
        """
        <OpenSCENARIO><ParameterDeclarations><ParameterDeclaration name="p" value="on"/>
        </ParameterDeclarations><VariableDeclarations><VariableDeclaration name="n" value="10"/>
        </VariableDeclarations><RoadNetwork><TrafficSignals><TrafficSignalController name="c">
        <Phase name="stop" duration="2"><TrafficSignalState trafficSignalId="12" state="red"/>
        </Phase><Phase name="go" duration="3"><TrafficSignalState trafficSignalId="12"
        state="green"/></Phase></TrafficSignalController></TrafficSignals></RoadNetwork><Entities>
        %s</Entities><Storyboard><Init><Actions><GlobalAction><EnvironmentAction><Environment
        name="e"><TimeOfDay animation="true" dateTime="2026-01-01T12:00:00Z"/></Environment>
        </EnvironmentAction></GlobalAction>%s</Actions></Init>%s%s</Storyboard></OpenSCENARIO>
        """;
    String events = story("", event("E", "<UserDefinedAction/>", when("none", 0, condition)), more);
    return Scenarios.run(tree(text.formatted(CARS, INIT, events, Scenarios.stop(100))));
  }

  @Test
  void valuesChange() {
    StoryboardRun clock =
        valued(
            value("<TimeOfDayCondition dateTime='2026-01-01T12:00:01Z' rule='greaterOrEqual'/>"),
            "");
    assertEquals(1, started(played(clock, 2)), 1e-9);
    StoryboardRun signal = valued(value("<TrafficSignalCondition name='12' state='green'/>"), "");
    assertEquals(2, started(played(signal, 6)), 1e-9);
    String set =
        "<GlobalAction><InfrastructureAction><TrafficSignalAction><TrafficSignalStateAction"
            + " name='12' state='green'/></TrafficSignalAction></InfrastructureAction>"
            + "</GlobalAction>";
    StoryboardRun one =
        valued(
            value("<TrafficSignalCondition name='12' state='green'/>"),
            event("F", set, after(0.5)));
    assertEquals(0.5, started(played(one, 2)), 1e-9);
    StoryboardRun phase =
        valued(
            value("<TrafficSignalCondition name='12' state='green'/>"),
            event(
                "F",
                set.replace(
                    "<TrafficSignalStateAction name='12' state='green'/>",
                    "<TrafficSignalControllerAction trafficSignalControllerRef='c' phase='go'/>"),
                after(0.5)));
    assertEquals(0.5, started(played(phase, 2)), 1e-9);
    String modify =
        "<GlobalAction><VariableAction variableRef='n'><ModifyAction><Rule><%s value='%s'/></Rule>"
            + "</ModifyAction></VariableAction></GlobalAction>";
    StoryboardRun sum =
        valued(
            value("<VariableCondition variableRef='n' rule='equalTo' value='24'/>"),
            event("F", modify.formatted("AddValue", 2), after(0.5))
                + event("H", modify.formatted("MultiplyByValue", 2), after(0.6)));
    assertEquals(0.6, started(played(sum, 2)), 1e-9);
    assertEquals("24", sum.variables().get("n"));
  }

  private static double started(StoryboardRun run) {
    return run.changes().stream()
        .filter(
            each -> each.path().endsWith("/E") && String.valueOf(each.transition()).equals("START"))
        .findFirst()
        .orElseThrow()
        .time();
  }
}
