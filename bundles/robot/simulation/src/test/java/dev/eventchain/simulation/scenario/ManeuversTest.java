package dev.eventchain.simulation.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.world.Actor;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.World;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Tests maneuvers that begin by what happens, and scenarios that end so. The ego has 10 m/s. */
class ManeuversTest {

  private static final String SCENE =
      """
      name: waiting
      title: A walker waits for the ego
      duration_s: 8
      ego: {speed_kmh: 36, coasting_deceleration_mps2: 0%s}
      actors:
        - {kind: pedestrian, name: walker, gap_m: 30, lateral_offset_m: -5, heading_deg: 90,
           speed_kmh: 0, length_m: 0.5, width_m: 0.5, maneuvers: [%s]}
        - {name: car, gap_m: 40, lateral_offset_m: 3.75, speed_kmh: 36, maneuvers: [%s]}
      accept: {no_impact: true}
      %s
      """;

  private static Trace run(String ego, String walker, String car, String end) {
    String text = SCENE.formatted(ego, walker, car, end);
    Scenario scenario = Scenario.parse(SourceText.of("s.yaml", text), Bench.carla());
    Trace trace = new Trace(scenario.inputs(), scenario.situation().road());
    World world = new World(scenario.situation(), trace);
    world.advanceTo(World.nanoseconds(scenario.duration()));
    return trace;
  }

  private static Actor walker(Trace trace) {
    return trace.actor("walker").orElseThrow();
  }

  /** From 1.00 s on, the gap is below 20.05 m. */
  private static final String WALKS =
      "{when: actor('walker').gap < 20.05 m, speed_kmh: 3.6, acceleration_mps2: 2}";

  @Test
  void anActorBeginsWhenItsConditionComesTrueAndThenFollowsItsTimes() {
    Trace trace = run("", WALKS + ", {after_s: 1.5, speed_kmh: 0, acceleration_mps2: 2}", "", "");
    assertEquals(-5, walker(trace).across(1.0));
    // 0.5 s to 1 m/s, 1 s at it, and 0.5 s to stand.
    assertEquals(-4.75, walker(trace).across(1.5), 1e-9);
    assertEquals(-3.75, walker(trace).across(2.5), 1e-9);
    assertEquals(-3.5, walker(trace).across(3.0), 1e-9);
    assertEquals(-3.5, walker(trace).across(8.0), 1e-9);
    assertEquals(List.of(), trace.neverBegun());
  }

  @Test
  void anActorMayWaitForAnother() {
    Trace trace = run("", WALKS, "{when: actor('walker').offset > -4 m, lateral_offset_m: 0}", "");
    Actor car = trace.actor("car").orElseThrow();
    // The walker is beyond 4 m after 1 + 0.5 + 0.75 s; 3.75 m aside take pi / 2 * 3.75 / 1.5 s.
    assertEquals(3.75, car.across(2.26));
    assertTrue(car.across(2.35) < 3.75);
    assertEquals(0, car.across(2.27 + 3.93), 1e-3);
  }

  @Test
  void theDriverMayWait() {
    String brakes =
        ", maneuvers: [{when: ego.position > 20.05 m, speed_kmh: 0, acceleration_mps2: 5}]";
    Trace trace = run(brakes, "", "", "");
    assertEquals(10, trace.stateAt(2_000_000_000L).speed());
    assertTrue(trace.stateAt(2_500_000_000L).speed() < 9);
  }

  @Test
  void whatNeverBeganIsKnown() {
    Trace trace =
        run(
            "",
            "{when: ego.speed > 11 m/s, speed_kmh: 3.6, acceleration_mps2: 2}",
            "{when: ego.speed > 12 m/s, speed_kmh: 0, acceleration_mps2: 2, optional: true}",
            "");
    assertEquals(List.of("that of walker when ego.speed > 11 m/s"), trace.neverBegun());
  }

  @Test
  void aScenarioEndsAsItSays() {
    Trace trace = run("", "", "", "end_when: actor('walker').gap < 10.05 m");
    assertEquals(2_000_000_000L, trace.end().time());
    assertTrue(!trace.isCut());
  }

  @Test
  void positionsBeforeAManeuverStayWhatTheyWere() {
    Trace trace = run("", WALKS, "", "");
    for (double seconds = 0; seconds <= 1; seconds += 0.1) {
      assertEquals(-5, walker(trace).across(seconds));
    }
  }

  @Test
  void aLateralManeuverMayHaveAConstantSpeed() {
    String linear = "{at_s: 1, lateral_offset_m: 0, lateral_speed_mps: 1.5, shape: linear}";
    Actor car = run("", "", linear, "").actor("car").orElseThrow();
    assertEquals(3.75, car.across(1.0));
    assertEquals(2.25, car.across(2.0), 1e-9);
    assertEquals(-1.5, car.speedAcross(2.0), 1e-9);
    assertEquals(0, car.across(3.5), 1e-9);
  }

  /** 1 s with growing speed, 1.5 s with a constant one, 1 s with a falling one. */
  @Test
  void aConstantLateralSpeedMayGrowAndFall() {
    String ramp =
        "{at_s: 1, lateral_offset_m: 0, lateral_speed_mps: 1.5, shape: linear,"
            + " lateral_acceleration_mps2: 1.5}";
    Actor car = run("", "", ramp, "").actor("car").orElseThrow();
    assertEquals(-0.75, car.speedAcross(1.5), 1e-9);
    assertEquals(3.75 - 0.1875, car.across(1.5), 1e-9);
    assertEquals(3.75 - 0.75, car.across(2.0), 1e-9);
    assertEquals(-1.5, car.speedAcross(3.0), 1e-9);
    assertEquals(3.75 - 2.25, car.across(3.0), 1e-9);
    assertEquals(-0.75, car.speedAcross(4.0), 1e-9);
    assertEquals(0.1875, car.across(4.0), 1e-9);
    assertEquals(0, car.across(4.5), 1e-9);
  }

  @Test
  void halfAWaveHasNoAccelerationOfItsOwn() {
    String wave = "{at_s: 1, lateral_offset_m: 0, lateral_acceleration_mps2: 1.5}";
    DiagnosticException refused =
        assertThrows(DiagnosticException.class, () -> run("", "", wave, ""));
    assertTrue(refused.getMessage().contains("half a wave"), refused.getMessage());
  }

  /** 1 m at 1 m/s2 takes 1 s to the middle and 1 s more, with 1 m/s at most. */
  @Test
  void aShortWayEndsBeforeItsLateralSpeedIsReached() {
    String ramp =
        "{at_s: 1, lateral_offset_m: 2.75, lateral_speed_mps: 5, shape: linear,"
            + " lateral_acceleration_mps2: 1}";
    Actor car = run("", "", ramp, "").actor("car").orElseThrow();
    assertEquals(3.25, car.across(2.0), 1e-9);
    assertEquals(-1, car.speedAcross(2.0), 1e-9);
    assertEquals(2.75, car.across(3.0), 1e-9);
  }

  @Test
  void anActorMayKeepItsHeading() {
    String aside = "{at_s: 1, lateral_offset_m: 0}";
    String speed = "speed_kmh: 36, maneuvers";
    for (boolean keeps : new boolean[] {false, true}) {
      String text = SCENE.formatted("", "", aside, "");
      text = text.replace(speed, (keeps ? "keeps_heading: true, " : "") + speed);
      Scenario scenario = Scenario.parse(SourceText.of("s.yaml", text), Bench.carla());
      Actor car = scenario.situation().actors().get(1);
      double heading = car.body(scenario.situation().road(), 2.0).place().heading();
      assertEquals(keeps, heading == 0.0);
    }
  }

  /** Its condition is true from the start, but the one before it begins after 2 s. */
  @Test
  void aManeuverWaitsForTheOneBeforeIt() {
    Trace trace =
        run(
            "",
            "{at_s: 2, speed_kmh: 3.6, acceleration_mps2: 2},"
                + " {when: ego.speed > 1 m/s, speed_kmh: 7.2, acceleration_mps2: 2}",
            "",
            "");
    assertEquals(-5, walker(trace).across(2.0));
    assertTrue(walker(trace).across(3.0) > -4.6);
  }

  /** Numbered names avoid those that the file gives, by which maneuvers are known. */
  @Test
  void noTwoActorsHaveOneName() {
    String text =
        """
        name: names
        title: Names
        duration_s: 5
        ego: {speed_kmh: 36}
        actors:
          - {name: car 1, gap_m: 30, speed_kmh: 0}
          - {gap_m: 60, speed_kmh: 0}
        accept: {no_impact: true}
        """;
    Scenario scenario = Scenario.parse(SourceText.of("s.yaml", text), Bench.carla());
    assertEquals(
        List.of("car 1", "car 2"),
        scenario.situation().actors().stream().map(Actor::name).toList());
  }
}
