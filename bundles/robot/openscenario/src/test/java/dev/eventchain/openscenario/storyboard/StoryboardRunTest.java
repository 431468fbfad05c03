package dev.eventchain.openscenario.storyboard;

import static dev.eventchain.openscenario.storyboard.Scenarios.STEP;
import static dev.eventchain.openscenario.storyboard.Scenarios.after;
import static dev.eventchain.openscenario.storyboard.Scenarios.car;
import static dev.eventchain.openscenario.storyboard.Scenarios.changes;
import static dev.eventchain.openscenario.storyboard.Scenarios.event;
import static dev.eventchain.openscenario.storyboard.Scenarios.ofEntity;
import static dev.eventchain.openscenario.storyboard.Scenarios.placed;
import static dev.eventchain.openscenario.storyboard.Scenarios.played;
import static dev.eventchain.openscenario.storyboard.Scenarios.run;
import static dev.eventchain.openscenario.storyboard.Scenarios.scenario;
import static dev.eventchain.openscenario.storyboard.Scenarios.speed;
import static dev.eventchain.openscenario.storyboard.Scenarios.state;
import static dev.eventchain.openscenario.storyboard.Scenarios.stop;
import static dev.eventchain.openscenario.storyboard.Scenarios.story;
import static dev.eventchain.openscenario.storyboard.Scenarios.value;
import static dev.eventchain.openscenario.storyboard.Scenarios.when;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.openscenario.storyboard.world.Collisions;
import dev.eventchain.openscenario.storyboard.world.ControlDomain;
import dev.eventchain.openscenario.storyboard.world.EntityState;
import dev.eventchain.openscenario.storyboard.world.Pose;
import dev.eventchain.openscenario.storyboard.world.Visibility;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** Tests what the world asks of a run, and tells it. */
class StoryboardRunTest {

  private static final String FASTER = speed("linear", "rate", 2, 30);

  private static StoryboardRun ego(String... events) {
    return run(scenario(car("Ego"), placed("Ego", -1, 100, 10), story("Ego", events) + stop(90)));
  }

  @Test
  void askingForTheNextStatesChangesNothing() {
    StoryboardRun run = ego(event("E", FASTER));
    Map<String, EntityState> next = run.next(STEP);
    assertEquals(next, run.next(STEP));
    assertEquals(100, state(run, "Ego").pose().x(), 1e-12);
    run.advance(STEP, Optional.empty(), Collisions.NONE);
    assertEquals(next, run.states());
  }

  /** The vehicle of the world brakes; the scenario goes on in time, and does not speed it up. */
  @Test
  void actionsDoNotMoveAnEgoThatSoftwareDrives() {
    StoryboardRun run = ego(event("E", FASTER, after(1)), event("F", FASTER, after(3)));
    played(run, 2);
    assertEquals(12, state(run, "Ego").speed(), 1e-9);
    run.handOver(Set.of(ControlDomain.LONGITUDINAL));
    double x = state(run, "Ego").pose().x();
    for (int i = 0; i < 400; i++) {
      double v = Math.max(0, state(run, "Ego").speed() - 5 * STEP);
      x += v * STEP;
      EntityState seen = EntityState.along(Pose.flat(x, -1.75, 0), v, Optional.empty());
      run.advance(STEP, Optional.of(seen), Collisions.NONE);
    }
    assertEquals(0, state(run, "Ego").speed(), 1e-9);
    assertEquals(x, state(run, "Ego").pose().x(), 1e-9);
    assertEquals(-1, state(run, "Ego").road().orElseThrow().lane());
    assertEquals(0, run.next(STEP).get("Ego").speed(), 1e-9);
    assertTrue(changes(run).contains("3.00 S/A/G/M/E/EAction STOP COMPLETE"));
    played(run, 15);
    assertTrue(changes(run).stream().anyMatch(each -> each.contains("F/FAction END COMPLETE")));
  }

  @Test
  void conditionsSeeWhereTheEgoReallyIs() {
    String slow = ofEntity("Ego", "<SpeedCondition rule='lessThan' value='5'/>");
    StoryboardRun run = ego(event("E", "<UserDefinedAction/>", when("none", 0, slow)));
    EntityState seen = EntityState.along(Pose.flat(100, -5, 0), 4, Optional.empty());
    run.advance(STEP, Optional.of(seen), Collisions.NONE);
    assertTrue(changes(run).contains("0.01 S/A/G/M/E START RUNNING"));
    assertEquals(-2, state(run, "Ego").road().orElseThrow().lane());
    run.advance(1, Optional.empty(), Collisions.NONE);
    assertEquals(104, state(run, "Ego").pose().x(), 1e-9);
    assertEquals(-5, state(run, "Ego").pose().y(), 1e-9);
  }

  @Test
  void entitiesComeAndGoAndHide() {
    String hide =
        "<PrivateAction><VisibilityAction graphics='true' sensors='false' traffic='true'/>"
            + "</PrivateAction>";
    String add =
        "<GlobalAction><EntityAction entityRef='Other'><AddEntityAction><Position><LanePosition"
            + " roadId='1' laneId='-2' s='50'/></Position></AddEntityAction></EntityAction>"
            + "</GlobalAction>";
    String delete =
        "<GlobalAction><EntityAction entityRef='Other'><DeleteEntityAction/></EntityAction>"
            + "</GlobalAction>";
    StoryboardRun run =
        run(
            scenario(
                car("Ego") + car("Other"),
                placed("Ego", -1, 100, 10),
                story(
                        "Other",
                        event("E", add, after(1)),
                        event("F", hide, after(2)),
                        event("G", delete, after(3)))
                    + stop(9)));
    assertFalse(state(run, "Other").exists());
    played(run, 1);
    assertEquals(50, state(run, "Other").pose().x(), 1e-9);
    played(run, 2);
    assertEquals(new Visibility(true, false, true), state(run, "Other").visibility());
    played(run, 3);
    assertFalse(state(run, "Other").exists());
    assertFalse(run.next(STEP).get("Other").exists());
  }

  @Test
  void keepsTheFrictionOfTheEnvironment() {
    String ice =
        "<GlobalAction><EnvironmentAction><Environment name='e'><RoadCondition"
            + " frictionScaleFactor='0.3'/></Environment></EnvironmentAction></GlobalAction>";
    StoryboardRun run =
        run(scenario(car("Ego"), ice + placed("Ego", -1, 100, 10), story("Ego", event("E", ice))));
    assertEquals(0.3, run.friction());
  }

  @Test
  void triggeringEntitiesMayBeTheActors() {
    String fast =
        "<ByEntityCondition><TriggeringEntities triggeringEntitiesRule='any'><EntityRef"
            + " entityRef='Ego'/><EntityRef entityRef='Other'/></TriggeringEntities>"
            + "<EntityCondition><SpeedCondition rule='greaterThan' value='15'/></EntityCondition>"
            + "</ByEntityCondition>";
    StoryboardRun run =
        run(
            scenario(
                car("Ego") + car("Other"),
                placed("Ego", -1, 100, 10) + placed("Other", -2, 100, 20),
                story("", event("E", speed("step", "time", 0, 1)))
                    .replace("selectTriggeringEntities='false'", "selectTriggeringEntities='true'")
                    .replace(
                        "</Act>",
                        "<StartTrigger><ConditionGroup>"
                            + when("none", 0, fast)
                            + "</ConditionGroup></StartTrigger></Act>")));
    assertEquals(10, state(run, "Ego").speed());
    assertEquals(1, state(run, "Other").speed());
  }

  /** An action of a selection ends for all when one of them is taken from it. */
  @Test
  void anActionOfSeveralEndsForAll() {
    String both =
        "<EntitySelection name='Both'><Members><ByType objectType='vehicle'/></Members>"
            + "</EntitySelection>";
    StoryboardRun run =
        run(
            scenario(
                car("Ego") + car("Other") + both,
                placed("Ego", -1, 100, 10) + placed("Other", -2, 100, 10),
                story("Both", event("E", FASTER))
                    + story("Ego", event("F", speed("step", "time", 0, 0), after(1)))
                        .replace("name='S'", "name='T'")
                    + stop(9)));
    played(run, 2);
    assertEquals(0, state(run, "Ego").speed());
    assertEquals(12, state(run, "Other").speed(), 1e-9);
    assertTrue(changes(run).contains("1.00 S/A/G/M/E/EAction STOP COMPLETE"));
  }

  @Test
  void anActHasTriggersOfItsOwn() {
    String act =
        story("Ego", event("E", FASTER))
            .replace(
                "</Act>",
                "<StartTrigger><ConditionGroup>"
                    + after(1)
                    + "</ConditionGroup></StartTrigger><StopTrigger><ConditionGroup>"
                    + after(2)
                    + "</ConditionGroup></StopTrigger></Act>");
    StoryboardRun run = run(scenario(car("Ego"), placed("Ego", -1, 100, 10), act));
    played(run, 3);
    assertEquals(12, state(run, "Ego").speed(), 1e-9);
    assertEquals("0.00 S/A null STANDBY", changes(run).get(1));
    assertTrue(changes(run).contains("1.00 S/A START RUNNING"));
    assertTrue(changes(run).contains("2.00 S/A STOP COMPLETE"));
    assertTrue(changes(run).contains("2.00 S END COMPLETE"));
    assertTrue(run.ended());
  }

  /** Any storyboard does a bounded number of things, and twice the same. */
  @Test
  void randomStoryboardsAreBoundedAndRepeatable() {
    for (int seed = 0; seed < 60; seed++) {
      String text = random(new Random(seed));
      List<String> first = changes(played(run(scenario(car("Ego"), INIT, text)), 1));
      List<String> second = changes(played(run(scenario(car("Ego"), INIT, text)), 1));
      assertEquals(first, second);
      // Each of four events starts, or is skipped, and its action and itself end, in each step.
      assertTrue(first.size() <= 101 * (4 * 4 + 6) + 20, "seed " + seed + ": " + first.size());
    }
  }

  private static final String INIT = placed("Ego", -1, 100, 10);

  private static String random(Random random) {
    List<String> events = new ArrayList<>();
    for (String name : List.of("E", "F", "G", "H")) {
      String action =
          pick(
              random,
              "<UserDefinedAction/>",
              FASTER,
              speed("step", "time", 0, 5),
              speed("cubic", "time", 0.2, 3));
      int most = 1 + random.nextInt(3) * 50;
      String priority = pick(random, "override", "parallel", "skip");
      events.add(
          random.nextInt(4) == 0
              ? event(name, priority, most, action)
              : event(name, priority, most, action, condition(random)));
    }
    return story("Ego", events.toArray(new String[0]))
        .replace("'G' maximumExecutionCount='1'", "'G' maximumExecutionCount='20'");
  }

  private static String condition(Random random) {
    String state =
        "<StoryboardElementStateCondition storyboardElementType='event' storyboardElementRef='"
            + pick(random, "E", "F", "G", "H")
            + "' state='"
            + pick(
                random,
                "standbyState",
                "runningState",
                "completeState",
                "startTransition",
                "endTransition",
                "stopTransition",
                "skipTransition")
            + "'/>";
    String edge = pick(random, "none", "rising", "falling", "risingOrFalling");
    return when(edge, random.nextInt(3) * 0.03, value(state));
  }

  private static String pick(Random random, String... choices) {
    return choices[random.nextInt(choices.length)];
  }

  @Test
  void anElementThatIsSkippedSaysSo() {
    StoryboardRun run =
        ego(
            event("E", FASTER),
            event("F", "skip", 1, "<UserDefinedAction/>", after(1)),
            event(
                "G",
                "<UserDefinedAction/>",
                when(
                    "none",
                    0,
                    value(
                        "<StoryboardElementStateCondition storyboardElementType='event'"
                            + " storyboardElementRef='M::F' state='skipTransition'/>"))));
    played(run, 2);
    assertTrue(changes(run).contains("1.00 S/A/G/M/G START RUNNING"));
  }
}
