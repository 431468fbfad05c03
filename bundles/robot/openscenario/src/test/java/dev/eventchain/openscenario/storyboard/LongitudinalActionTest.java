package dev.eventchain.openscenario.storyboard;

import static dev.eventchain.openscenario.storyboard.Scenarios.after;
import static dev.eventchain.openscenario.storyboard.Scenarios.car;
import static dev.eventchain.openscenario.storyboard.Scenarios.changes;
import static dev.eventchain.openscenario.storyboard.Scenarios.event;
import static dev.eventchain.openscenario.storyboard.Scenarios.longitudinal;
import static dev.eventchain.openscenario.storyboard.Scenarios.placed;
import static dev.eventchain.openscenario.storyboard.Scenarios.played;
import static dev.eventchain.openscenario.storyboard.Scenarios.run;
import static dev.eventchain.openscenario.storyboard.Scenarios.scenario;
import static dev.eventchain.openscenario.storyboard.Scenarios.speed;
import static dev.eventchain.openscenario.storyboard.Scenarios.state;
import static dev.eventchain.openscenario.storyboard.Scenarios.story;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.openscenario.storyboard.world.EntityState;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Tests distances to others, sequences of speeds, and arrivals. Fronts are 3 m before, and rears 1
 * m behind the reference points.
 */
class LongitudinalActionTest {

  private static final double EXACT = 1e-6;

  private static StoryboardRun both(String action, String... events) {
    return run(
        scenario(
            car("Ego") + car("Other"),
            placed("Ego", -1, 100, 10) + placed("Other", -1, 150, 10),
            story("Ego", event("E", action, after(1)))
                + story("Other", events).replace("name='S'", "name='T'")));
  }

  private static String distance(String attributes, String limits) {
    return longitudinal(
        "<LongitudinalDistanceAction entityRef='Other' "
            + attributes
            + ">"
            + limits
            + "</LongitudinalDistanceAction>");
  }

  private static double gap(StoryboardRun run) {
    return state(run, "Other").pose().x() - state(run, "Ego").pose().x();
  }

  @ParameterizedTest
  @CsvSource({
    "freespace='true' distance='20' displacement='trailingReferencedEntity', 24",
    "freespace='true' distance='20', 24",
    "freespace='false' distance='20', 20",
    "freespace='false' timeGap='3', 30",
    "freespace='true' timeGap='3' coordinateSystem='lane', 34",
    "freespace='true' distance='12' displacement='leadingReferencedEntity', -16",
    "freespace='true' distance='12' displacement='leadingReferencedEntity'"
        + " coordinateSystem='road', -16",
  })
  void isThereAtOnceWithoutConstraints(String attributes, double apart) {
    StoryboardRun run = played(both(distance(attributes + " continuous='false'", "")), 2);
    assertEquals(apart, gap(run), EXACT);
    assertEquals(160 + 10 - apart, state(run, "Ego").pose().x(), EXACT);
    assertEquals(10, state(run, "Ego").speed(), EXACT);
    assertTrue(changes(run).contains("1.00 S/A/G/M/E END COMPLETE"));
  }

  @Test
  void holdsADistanceAsIfCoupled() {
    StoryboardRun run =
        both(
            distance("freespace='false' distance='20' continuous='true'", ""),
            event("F", speed("linear", "rate", 4, 2), after(2)));
    for (double time = 1.5; time < 6; time += 0.5) {
      assertEquals(20, gap(played(run, time)), 2e-3);
    }
    assertEquals(2, state(run, "Ego").speed(), 1e-6);
    assertTrue(changes(run).stream().noneMatch(each -> each.contains("S/A/G/M/E END")));
  }

  /** 30 m are gained by speeding up for half of the time and slowing down for the rest. */
  @Test
  void closesAGapAsFastAsItMay() {
    String limits = "<DynamicConstraints maxAcceleration='2' maxDeceleration='2' maxSpeed='50'/>";
    StoryboardRun run =
        played(both(distance("freespace='false' distance='20' continuous='false'", limits)), 20);
    assertEquals(20, gap(run), 0.1);
    assertEquals(10, state(run, "Ego").speed(), 0.1);
    double end =
        run.changes().stream()
            .filter(each -> each.path().endsWith("EAction"))
            .reduce((first, second) -> second)
            .orElseThrow()
            .time();
    assertEquals(1 + 2 * Math.sqrt(30 / 2.0), end, 0.3);
  }

  @Test
  void keepsATimeGapToOneThatBrakes() {
    String limits = "<DynamicConstraints maxAcceleration='3' maxDeceleration='6' maxSpeed='50'/>";
    StoryboardRun run =
        both(
            distance("freespace='true' timeGap='2' continuous='true'", limits),
            event("F", speed("linear", "rate", 2, 5), after(30)));
    assertEquals(24, gap(played(run, 30)), 0.05);
    assertEquals(14, gap(played(run, 60)), 0.05);
    assertEquals(5, state(run, "Ego").speed(), 0.01);
  }

  @Test
  void goesThroughAProfileOfSpeeds() {
    String entries =
        "<SpeedProfileEntry speed='20' time='2'/><SpeedProfileEntry speed='20' time='3'/>"
            + "<SpeedProfileEntry speed='5' time='5'/>";
    StoryboardRun run =
        both(
            longitudinal(
                "<SpeedProfileAction followingMode='position'>"
                    + entries
                    + "</SpeedProfileAction>"));
    played(run, 2);
    assertEquals(15, state(run, "Ego").speed(), EXACT);
    assertEquals(5, state(run, "Ego").acceleration(), EXACT);
    played(run, 12);
    assertEquals(110 + 30 + 60 + 62.5 + 5, state(run, "Ego").pose().x(), EXACT);
    assertEquals(5, state(run, "Ego").speed(), EXACT);
    assertTrue(changes(run).contains("11.00 S/A/G/M/E END COMPLETE"));
  }

  @Test
  void goesThroughAProfileAsFastAsItMay() {
    String entries = "<SpeedProfileEntry speed='20'/><SpeedProfileEntry speed='0'/>";
    String limits = "<DynamicConstraints maxAcceleration='2' maxDeceleration='4'/>";
    StoryboardRun run =
        both(
            longitudinal(
                "<SpeedProfileAction followingMode='position'>"
                    + limits
                    + entries
                    + "</SpeedProfileAction>"));
    played(run, 13);
    assertEquals(110 + 15 * 5 + 10 * 5, state(run, "Ego").pose().x(), EXACT);
    assertTrue(changes(run).contains("11.00 S/A/G/M/E END COMPLETE"));
    StoryboardRun follow =
        both(
            longitudinal(
                "<SpeedProfileAction followingMode='follow'><SpeedProfileEntry speed='20'"
                    + " time='1'/></SpeedProfileAction>"));
    assertEquals(15, state(played(follow, 2), "Ego").speed(), EXACT);
  }

  private static StoryboardRun meeting(String last, String... events) {
    String action =
        "<PrivateAction><SynchronizeAction masterEntityRef='Ego'><TargetPositionMaster>"
            + "<LanePosition roadId='1' laneId='-1' s='200'/></TargetPositionMaster>"
            + "<TargetPosition><LanePosition roadId='1' laneId='-2' s='180'/></TargetPosition>"
            + last
            + "</SynchronizeAction></PrivateAction>";
    return run(
        scenario(
            car("Ego") + car("Other"),
            placed("Ego", -1, 100, 10) + placed("Other", -2, 80, 4),
            story("Other", event("E", action))
                + story("Ego", events).replace("name='S'", "name='T'")));
  }

  /** 100 m in 10 s from 4 m/s: the last speed is twice the mean one less the first. */
  @Test
  void arrivesWithTheMaster() {
    StoryboardRun run = played(meeting(""), 5);
    assertEquals(10, state(run, "Other").speed(), EXACT);
    assertEquals(80 + 20 + 0.5 * 1.2 * 25, state(run, "Other").pose().x(), EXACT);
    played(run, 10);
    assertEquals(180, state(run, "Other").pose().x(), EXACT);
    assertEquals(16, state(run, "Other").speed(), 1e-4);
    assertTrue(
        changes(run).stream().anyMatch(each -> each.matches("(9.99|10.00) S/A/G/M/E END.*")));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<AbsoluteSpeed value='12'/> | 12",
        "<RelativeSpeedToMaster speedTargetValueType='delta' value='-1'/> | 9",
        "<RelativeSpeedToMaster speedTargetValueType='factor' value='1.2'/> | 12",
        "<AbsoluteSpeed value='12'><TargetDistanceSteadyState distance='6'/></AbsoluteSpeed> | 12",
        "<AbsoluteSpeed value='12'><TargetTimeSteadyState time='0.5'/></AbsoluteSpeed> | 12",
      })
  void arrivesWithASpeed(String last, double speed) {
    StoryboardRun run = meeting("<FinalSpeed>" + last + "</FinalSpeed>");
    played(run, 9.8);
    if (last.contains("Steady")) {
      assertEquals(speed, state(run, "Other").speed(), 1e-2);
    }
    played(run, 10);
    assertEquals(180, state(run, "Other").pose().x(), 1e-3);
    assertEquals(speed, state(run, "Other").speed(), 1e-2);
  }

  /** The master has 80 m left when it gets slower; it then takes 16 s. */
  @Test
  void arrivesWithAMasterThatBrakes() {
    StoryboardRun run = meeting("", event("F", speed("step", "time", 0, 5), after(2)));
    played(run, 18);
    assertEquals(200, state(run, "Ego").pose().x(), EXACT);
    assertEquals(180, state(run, "Other").pose().x(), 0.01);
  }

  @Test
  void waitsForAMasterThatStands() {
    StoryboardRun run =
        meeting(
            "",
            event("F", speed("linear", "rate", 5, 0), after(4)),
            event("G", speed("linear", "rate", 1, 5), after(20)));
    played(run, 20);
    EntityState waiting = state(run, "Other");
    assertEquals(0, waiting.speed(), EXACT);
    assertTrue(waiting.pose().x() < 180);
    for (double time = 20; state(run, "Ego").pose().x() < 199.95; time += 0.01) {
      played(run, time);
    }
    assertEquals(180, state(run, "Other").pose().x(), 0.5);
  }
}
