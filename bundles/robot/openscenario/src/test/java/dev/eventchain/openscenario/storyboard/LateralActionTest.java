package dev.eventchain.openscenario.storyboard;

import static dev.eventchain.openscenario.storyboard.Scenarios.after;
import static dev.eventchain.openscenario.storyboard.Scenarios.at;
import static dev.eventchain.openscenario.storyboard.Scenarios.car;
import static dev.eventchain.openscenario.storyboard.Scenarios.changes;
import static dev.eventchain.openscenario.storyboard.Scenarios.event;
import static dev.eventchain.openscenario.storyboard.Scenarios.lateral;
import static dev.eventchain.openscenario.storyboard.Scenarios.placed;
import static dev.eventchain.openscenario.storyboard.Scenarios.played;
import static dev.eventchain.openscenario.storyboard.Scenarios.run;
import static dev.eventchain.openscenario.storyboard.Scenarios.scenario;
import static dev.eventchain.openscenario.storyboard.Scenarios.state;
import static dev.eventchain.openscenario.storyboard.Scenarios.story;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.openscenario.storyboard.world.EntityState;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Tests motions across lanes, which are 3.5 m wide. The ego drives in the middle of lane -1, y =
 * -1.75 m, at 20 m/s; the other one beside it on lane -2, y = -5.25 m.
 */
class LateralActionTest {

  private static final double EXACT = 1e-6;

  private static StoryboardRun ego(String action) {
    return run(
        scenario(
            car("Ego") + car("Other"),
            placed("Ego", -1, 100, 20) + placed("Other", -2, 100, 20),
            story("Ego", event("E", lateral(action), after(1)))));
  }

  private static String laneChange(
      String shape, String dimension, double value, String target, String offset) {
    return String.format(
        Locale.ROOT,
        "<LaneChangeAction %s><LaneChangeActionDynamics dynamicsShape='%s' dynamicsDimension='%s'"
            + " value='%s'/><LaneChangeTarget>%s</LaneChangeTarget></LaneChangeAction>",
        offset,
        shape,
        dimension,
        value,
        target);
  }

  @ParameterizedTest
  @CsvSource({
    "linear, time, 3, 3",
    "sinusoidal, time, 3, 3",
    "cubic, time, 3, 3",
    "sinusoidal, distance, 60, 3",
    "cubic, rate, 1.75, 3",
    "linear, rate, 1, 3.5",
  })
  void changesTheLane(String shape, String dimension, double value, double duration) {
    StoryboardRun run =
        ego(laneChange(shape, dimension, value, "<AbsoluteTargetLane value='-2'/>", ""));
    played(run, 1 + duration / 2);
    EntityState half = state(run, "Ego");
    double slope =
        switch (shape) {
          case "linear" -> 1;
          case "cubic" -> 1.5;
          default -> Math.PI / 2;
        };
    assertEquals(-3.5, half.pose().y(), EXACT);
    assertEquals(100 + 20 * (1 + duration / 2), half.pose().x(), EXACT);
    assertEquals(-3.5 * slope / duration, half.vy(), EXACT);
    assertEquals(Math.atan2(-3.5 * slope / duration, 20), half.pose().heading(), EXACT);
    played(run, 1 + duration / 4 * 3);
    played(run, 6);
    EntityState end = state(run, "Ego");
    assertEquals(-5.25, end.pose().y(), EXACT);
    assertEquals(0, end.pose().heading(), EXACT);
    assertEquals(-2, end.road().orElseThrow().lane());
    assertTrue(
        changes(run)
            .contains(
                String.format(Locale.ROOT, "%.2f S/A/G/M/E/EAction END COMPLETE", 1 + duration)));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<RelativeTargetLane entityRef='Ego' value='1'/> | | 1.75",
        "<RelativeTargetLane entityRef='Other' value='0'/> | targetLaneOffset='0.5' | -4.75",
        "<AbsoluteTargetLane value='2'/> | | 5.25",
      })
  void findsTheTargetLane(String target, String offset, double y) {
    String more = offset == null ? "" : offset;
    StoryboardRun run = played(ego(laneChange("cubic", "time", 2, target, more)), 4);
    assertEquals(y, state(run, "Ego").pose().y(), EXACT);
    StoryboardRun atOnce = played(ego(laneChange("step", "time", 0, target, more)), 1);
    assertEquals(y, state(atOnce, "Ego").pose().y(), EXACT);
    assertEquals(120, state(atOnce, "Ego").pose().x(), EXACT);
  }

  @Test
  void refusesALaneThatIsNotThere() {
    StoryboardRun run = ego(laneChange("cubic", "time", 2, "<AbsoluteTargetLane value='-3'/>", ""));
    assertEquals(
        "storyboard.place.none",
        assertThrows(DiagnosticException.class, () -> played(run, 2)).diagnostics().get(0).id());
  }

  /** With peaks of 6 d / T^2 for a cubic curve, and of pi^2 d / 2 T^2 for a sinusoidal one. */
  @ParameterizedTest
  @CsvSource({"cubic, 1.5, 2", "sinusoidal, 1.2337005501, 2", "linear, 1, 2"})
  void changesTheOffsetWithinTheAcceleration(String shape, double acceleration, double duration) {
    String action =
        "<LaneOffsetAction continuous='false'><LaneOffsetActionDynamics dynamicsShape='"
            + shape
            + "' maxLateralAcc='"
            + acceleration
            + "'/><LaneOffsetTarget><AbsoluteTargetLaneOffset value='1'/></LaneOffsetTarget>"
            + "</LaneOffsetAction>";
    StoryboardRun run = played(ego(action), 1 + duration / 2);
    assertEquals(-1.25, state(run, "Ego").pose().y(), EXACT);
    played(run, 4);
    assertEquals(-0.75, state(run, "Ego").pose().y(), EXACT);
    assertTrue(changes(run).stream().anyMatch(each -> each.matches("3.0[01] S/A/G/M/E END .*")));
  }

  @Test
  void anOffsetMayBeThereAtOnceAndLast() {
    String action =
        "<LaneOffsetAction continuous='%s'><LaneOffsetActionDynamics dynamicsShape='%s'/>"
            + "<LaneOffsetTarget><RelativeTargetLaneOffset entityRef='Other' value='0.5'/>"
            + "</LaneOffsetTarget></LaneOffsetAction>";
    StoryboardRun run = played(ego(action.formatted("false", "step")), 1);
    assertEquals(-1.25, state(run, "Ego").pose().y(), EXACT);
    assertTrue(changes(run).contains("1.00 S/A/G/M/E END COMPLETE"));
    StoryboardRun lasting = played(ego(action.formatted("true", "cubic")), 5);
    assertEquals(-1.25, state(lasting, "Ego").pose().y(), EXACT);
    assertTrue(changes(lasting).stream().noneMatch(each -> each.contains("E END")));
  }

  @ParameterizedTest
  @CsvSource({
    "true, leftToReferencedEntity, 1, -2.25",
    "false, leftToReferencedEntity, 1, -4.25",
    "true, any, 0.5, -2.75",
    "true, rightToReferencedEntity, 1, -8.25",
  })
  void keepsALateralDistance(boolean freespace, String displacement, double distance, double y) {
    String action =
        "<LateralDistanceAction entityRef='Other' continuous='false' freespace='"
            + freespace
            + "' displacement='"
            + displacement
            + "' distance='"
            + distance
            + "'>%s</LateralDistanceAction>";
    StoryboardRun atOnce = played(ego(action.formatted("")), 1);
    assertEquals(y, state(atOnce, "Ego").pose().y(), EXACT);
    String limits = "<DynamicConstraints maxSpeed='1'/>";
    StoryboardRun slow = ego(action.formatted(limits));
    double duration = 1.5 * Math.abs(y + 1.75);
    played(slow, 1 + Math.floor(duration * 50) / 100);
    assertTrue(Math.abs(state(slow, "Ego").vy()) > 0.98);
    played(slow, 1 + duration + 0.02);
    assertEquals(y, state(slow, "Ego").pose().y(), EXACT);
  }

  @Test
  void anotherMotionStopsOneThatRuns() {
    String change = laneChange("linear", "time", 4, "<AbsoluteTargetLane value='-2'/>", "");
    String back = laneChange("linear", "time", 2, "<AbsoluteTargetLane value='-1'/>", "");
    StoryboardRun run =
        run(
            scenario(
                car("Ego"),
                Scenarios.privately("Ego", at(-1, 100), Scenarios.speed("step", "time", 0, 20)),
                story(
                    "Ego",
                    event("E", lateral(change), after(1)),
                    event("F", lateral(back), after(3)))));
    played(run, 4);
    assertEquals(-1.75 - 3.5 / 4, state(run, "Ego").pose().y(), EXACT);
    assertTrue(changes(run).contains("3.00 S/A/G/M/E/EAction STOP COMPLETE"));
  }
}
