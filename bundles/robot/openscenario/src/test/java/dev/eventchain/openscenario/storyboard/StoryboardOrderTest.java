package dev.eventchain.openscenario.storyboard;

import static dev.eventchain.openscenario.storyboard.Scenarios.after;
import static dev.eventchain.openscenario.storyboard.Scenarios.car;
import static dev.eventchain.openscenario.storyboard.Scenarios.changes;
import static dev.eventchain.openscenario.storyboard.Scenarios.event;
import static dev.eventchain.openscenario.storyboard.Scenarios.placed;
import static dev.eventchain.openscenario.storyboard.Scenarios.played;
import static dev.eventchain.openscenario.storyboard.Scenarios.run;
import static dev.eventchain.openscenario.storyboard.Scenarios.scenario;
import static dev.eventchain.openscenario.storyboard.Scenarios.speed;
import static dev.eventchain.openscenario.storyboard.Scenarios.stop;
import static dev.eventchain.openscenario.storyboard.Scenarios.story;
import static dev.eventchain.openscenario.storyboard.Scenarios.timeIs;
import static dev.eventchain.openscenario.storyboard.Scenarios.value;
import static dev.eventchain.openscenario.storyboard.Scenarios.when;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

/** Tests the order of what happens in a storyboard. */
class StoryboardOrderTest {

  private static final String FAST = speed("linear", "time", 2, 20);

  private static List<String> events(double until, String... events) {
    StoryboardRun run = run(scenario(car("Ego"), placed("Ego", -1, 100, 10), story("Ego", events)));
    return changes(played(run, until)).stream()
        .map(each -> each.replace("S/A/G/M/", ""))
        .filter(each -> each.matches("\\S+ [EFG] .*"))
        .toList();
  }

  private static String state(String type, String name, String state) {
    return when(
        "none",
        0,
        value(
            "<StoryboardElementStateCondition storyboardElementType='"
                + type
                + "' storyboardElementRef='"
                + name
                + "' state='"
                + state
                + "'/>"));
  }

  @Test
  void runsAndEndsFromTheInsideOut() {
    StoryboardRun run =
        run(scenario(car("Ego"), placed("Ego", -1, 100, 10), story("Ego", event("E", FAST))));
    assertFalse(run.ended());
    played(run, 3);
    assertEquals(
        List.of(
            "0.00 S START RUNNING",
            "0.00 S/A START RUNNING",
            "0.00 S/A/G START RUNNING",
            "0.00 S/A/G/M START RUNNING",
            "0.00 S/A/G/M/E null STANDBY",
            "0.00 S/A/G/M/E START RUNNING",
            "0.00 S/A/G/M/E/EAction START RUNNING",
            "2.00 S/A/G/M/E/EAction END COMPLETE",
            "2.00 S/A/G/M/E END COMPLETE",
            "2.00 S/A/G/M END COMPLETE",
            "2.00 S/A/G END COMPLETE",
            "2.00 S/A END COMPLETE",
            "2.00 S END COMPLETE"),
        changes(run));
    assertTrue(run.ended());
    assertFalse(run.hasStop());
  }

  @Test
  void anOverridingEventStopsTheOthersOfItsManeuver() {
    assertEquals(
        List.of(
            "0.00 E null STANDBY",
            "0.00 F null STANDBY",
            "0.00 E START RUNNING",
            "1.00 E STOP COMPLETE",
            "1.00 F START RUNNING",
            "1.00 F END COMPLETE"),
        events(
            3,
            event("E", "parallel", 5, FAST, after(0)),
            event("F", "override", 1, "<UserDefinedAction/>", after(1))));
  }

  @Test
  void aSkippedEventCountsAsExecuted() {
    assertEquals(
        List.of(
            "0.00 E null STANDBY",
            "0.00 F null STANDBY",
            "0.00 E START RUNNING",
            "1.00 F SKIP STANDBY",
            "1.01 F SKIP COMPLETE",
            "2.00 E END COMPLETE"),
        events(
            3,
            event("E", FAST, after(0)),
            event("F", "skip", 2, "<UserDefinedAction/>", after(1))));
  }

  @Test
  void anEventIsExecutedAsOftenAsItSays() {
    assertEquals(
        List.of(
            "0.00 E null STANDBY",
            "1.00 E START RUNNING",
            "1.00 E END STANDBY",
            "1.01 E START RUNNING",
            "1.01 E END STANDBY",
            "1.02 E START RUNNING",
            "1.02 E END COMPLETE"),
        events(3, event("E", "parallel", 3, "<UserDefinedAction/>", after(1))));
  }

  /** A follower stands before what it follows. */
  @Test
  void aConditionSeesWhatEndsInTheSameStep() {
    assertEquals(
        List.of(
            "0.00 F null STANDBY",
            "0.00 E null STANDBY",
            "0.00 E START RUNNING",
            "2.00 E END COMPLETE",
            "2.00 F START RUNNING",
            "2.00 F END COMPLETE"),
        events(
            4,
            event("F", "parallel", 1, "<UserDefinedAction/>", state("event", "E", "endTransition")),
            event("E", FAST)));
  }

  /** Each waits for the start of the other, and is executed once in a step. */
  @Test
  void eventsDoNotStartEachOtherForEver() {
    String other = "<UserDefinedAction/>";
    List<String> changes =
        events(
            3,
            event("E", "parallel", 50, other, state("event", "F", "endTransition")),
            event("F", "parallel", 50, other, state("event", "E", "endTransition")),
            event("G", "parallel", 1, other, state("event", "E", "standbyState")));
    assertTrue(changes.size() < 10, changes::toString);
    List<String> both =
        events(
            3,
            event("E", "parallel", 50, other, state("event", "F", "standbyState")),
            event("F", "parallel", 50, other, state("event", "E", "standbyState")));
    // E does not stand by after its last execution, for which F then waits.
    assertEquals(2 + 2 * 50 + 2 * 49, both.size());
  }

  @Test
  void edgesNeedAnEarlierStep() {
    String action = "<UserDefinedAction/>";
    assertEquals(
        List.of("0.00 E null STANDBY"),
        events(1, event("E", action, when("rising", 0, timeIs("greaterOrEqual", 0)))));
    assertEquals(
        "0.50 E START RUNNING",
        events(1, event("E", action, when("rising", 0, timeIs("greaterOrEqual", 0.5)))).get(1));
    assertEquals(
        "0.51 E START RUNNING",
        events(1, event("E", action, when("falling", 0, timeIs("lessOrEqual", 0.5)))).get(1));
    assertEquals(
        List.of("0.50 E START RUNNING", "0.51 E START RUNNING"),
        events(
                1,
                event(
                    "E", "parallel", 2, action, when("risingOrFalling", 0, timeIs("equalTo", 0.5))))
            .stream()
            .filter(each -> each.contains("START"))
            .toList());
  }

  @Test
  void aDelayIsThatOfTheConditionWithItsEdge() {
    String action = "<UserDefinedAction/>";
    assertEquals(
        "0.80 E START RUNNING",
        events(1, event("E", action, when("rising", 0.3, timeIs("greaterOrEqual", 0.5)))).get(1));
    assertEquals(
        "0.30 E START RUNNING",
        events(1, event("E", action, when("none", 0.3, timeIs("lessThan", 0.2)))).get(1));
  }

  @Test
  void theStopTriggerEndsAll() {
    StoryboardRun run =
        run(
            scenario(
                car("Ego"), placed("Ego", -1, 100, 10), story("Ego", event("E", FAST)) + stop(1)));
    assertTrue(run.hasStop());
    played(run, 0.99);
    assertFalse(run.ended());
    played(run, 1);
    assertTrue(run.ended());
    assertEquals(
        List.of("1.00 S/A/G/M/E/EAction STOP COMPLETE", "1.00 S/A/G/M/E STOP COMPLETE"),
        changes(run).subList(7, 9));
  }

  @Test
  void aGroupIsExecutedAgainAtOnce() {
    String story = story("Ego", event("E", FAST)).replace("Count='1'><Actors", "Count='2'><Actors");
    StoryboardRun run = run(scenario(car("Ego"), placed("Ego", -1, 100, 10), story));
    List<String> groups =
        changes(played(run, 5)).stream().filter(each -> each.contains("A/G ")).toList();
    assertEquals(
        List.of(
            "0.00 S/A/G START RUNNING",
            "2.00 S/A/G END STANDBY",
            "2.00 S/A/G START RUNNING",
            "4.00 S/A/G END COMPLETE"),
        groups);
    assertEquals(20, Scenarios.state(run, "Ego").speed(), 1e-9);
  }
}
