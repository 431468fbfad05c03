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
import static dev.eventchain.openscenario.storyboard.Scenarios.state;
import static dev.eventchain.openscenario.storyboard.Scenarios.story;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests changes of speed against closed formulas. */
class SpeedActionTest {

  private static final double EXACT = 1e-6;

  private static StoryboardRun ego(double from, String action) {
    return run(
        scenario(
            car("Ego") + car("Other"),
            placed("Ego", -1, 100, from) + placed("Other", -2, 100, 8),
            story("Ego", event("E", action, after(1)))));
  }

  /** All shapes are symmetric, so the way is that of the mean speed. */
  @ParameterizedTest
  @CsvSource({
    "linear, time, 4, 4",
    "cubic, time, 4, 4",
    "sinusoidal, time, 4, 4",
    "linear, rate, 2, 5",
    "cubic, rate, 2, 7.5",
    "sinusoidal, rate, 2, 7.8539816",
    "linear, distance, 60, 4",
    "cubic, distance, 60, 4",
    "sinusoidal, distance, 60, 4",
  })
  void reachesTheTargetWhenItsDynamicsSay(
      String shape, String dimension, double value, double duration) {
    StoryboardRun run = ego(10, speed(shape, dimension, value, 20));
    played(run, 1 + duration / 2);
    double half = run.time() - 1;
    assertEquals(shaped(shape, 10, 20, half / duration), state(run, "Ego").speed(), EXACT);
    played(run, 20);
    double end = 100 + 10 + 15 * duration + 20 * (19 - duration);
    assertEquals(end, state(run, "Ego").pose().x(), 1e-4 * (duration == 7.8539816 ? 1 : 0.01));
    assertEquals(20, state(run, "Ego").speed(), EXACT);
    double reported = Math.ceil((1 + duration) * 100 - 1e-4) / 100;
    assertTrue(
        changes(run)
            .contains(String.format(Locale.ROOT, "%.2f S/A/G/M/E/EAction END COMPLETE", reported)),
        () -> changes(run).toString());
  }

  private static double shaped(String shape, double from, double to, double part) {
    return from
        + (to - from)
            * switch (shape) {
              case "linear" -> part;
              case "cubic" -> 3 * Math.pow(part, 2) - 2 * Math.pow(part, 3);
              default -> Math.pow(Math.sin(part * Math.PI / 2), 2);
            };
  }

  @Test
  void stepsAtOnceAndEndsInTheSameStep() {
    StoryboardRun run = played(ego(10, speed("step", "time", 0, 3)), 2);
    assertEquals(100 + 10 + 3, state(run, "Ego").pose().x(), EXACT);
    assertTrue(changes(run).contains("1.00 S/A/G/M/E/EAction START RUNNING"));
    assertTrue(changes(run).contains("1.00 S/A/G/M/E/EAction END COMPLETE"));
  }

  @ParameterizedTest
  @CsvSource({"delta, 3, 11", "factor, 1.5, 12"})
  void isRelativeToAnother(String type, double value, double target) {
    String relative =
        "<RelativeTargetSpeed entityRef='Other' continuous='false' speedTargetValueType='"
            + type
            + "' value='"
            + value
            + "'/>";
    StoryboardRun run = played(ego(10, speed("linear", "time", 1, relative)), 3);
    assertEquals(target, state(run, "Ego").speed(), EXACT);
    assertEquals(100 + 10 + (10 + target) / 2 + target, state(run, "Ego").pose().x(), EXACT);
  }

  @Test
  void followsAnotherForEver() {
    String relative =
        "<RelativeTargetSpeed entityRef='Other' continuous='true' speedTargetValueType='delta'"
            + " value='0'/>";
    StoryboardRun run =
        run(
            scenario(
                car("Ego") + car("Other"),
                placed("Ego", -1, 100, 10) + placed("Other", -2, 100, 8),
                story("Ego", event("E", speed("step", "time", 0, relative)))
                    + story("Other", event("F", speed("linear", "time", 2, 4), after(1)))
                        .replace("name='S'", "name='T'")));
    played(run, 5);
    assertEquals(4, state(run, "Ego").speed(), EXACT);
    assertTrue(changes(run).stream().noneMatch(each -> each.contains("S/A/G/M/E END")));
  }

  /** A speed beyond that of the vehicle is not reached; a rate is, unless it is to be followed. */
  @Test
  void keepsTheLimitsOfTheVehicle() {
    StoryboardRun fast = played(ego(10, speed("linear", "time", 1, 100)), 5);
    assertEquals(60, state(fast, "Ego").speed(), EXACT);
    String follow =
        speed("linear", "time", 1, 20).replace("value='1.0'", "value='1' followingMode='follow'");
    StoryboardRun slow = played(ego(10, follow), 2.5);
    assertEquals(10 + 1.5 * 5, state(slow, "Ego").speed(), EXACT);
  }

  @Test
  void aLaterActionOverridesARunningOne() {
    StoryboardRun run =
        run(
            scenario(
                car("Ego"),
                placed("Ego", -1, 100, 10),
                story(
                    "Ego",
                    event("E", speed("linear", "rate", 1, 30), after(1)),
                    event("F", speed("linear", "rate", 2, 0), after(3)))));
    played(run, 5);
    assertEquals(12 - 4, state(run, "Ego").speed(), EXACT);
    assertTrue(changes(run).contains("3.00 S/A/G/M/E/EAction STOP COMPLETE"));
    assertTrue(changes(run).contains("3.00 S/A/G/M/E END COMPLETE"));
  }
}
