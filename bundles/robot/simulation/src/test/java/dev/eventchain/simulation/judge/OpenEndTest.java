package dev.eventchain.simulation.judge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.simulation.AebProject;
import dev.eventchain.simulation.WorldRuns;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.run.ScenarioRun;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.ScenarioVerdict.CriterionResult;
import dev.eventchain.simulation.world.VehicleCommand;
import dev.eventchain.simulation.world.World;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests which runs end too soon to tell whether there is an impact. */
class OpenEndTest {

  private static final Path FILES = Path.of("src/test/resources/openscenario");

  @TempDir Path folder;

  /** Approaches at 50 km/h = 13.9 m/s with some brake; full braking is 8 m/s2. */
  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      quoteCharacter = '"',
      value = {
        // A car that stands, without and with half of what it takes, and with all of it.
        "0.0; 4; gap_m: 70, speed_kmh: 0; no_impact: true; true",
        "0.1; 4; gap_m: 70, speed_kmh: 0; no_impact: true; true",
        "1.0; 2; gap_m: 70, speed_kmh: 0; no_impact: true; false",
        "1.0; 8; gap_m: 70, speed_kmh: 0; no_impact: true; false",
        // One that is not slower, or so little that the ego follows it.
        "0.0; 4; gap_m: 20, speed_kmh: 50; no_impact: true; false",
        "0.0; 4; gap_m: 20, speed_kmh: 60; no_impact: true; false",
        "0.0; 4; gap_m: 20, speed_kmh: 46; no_impact: true; false",
        "0.0; 4; gap_m: 50, speed_kmh: 20; no_impact: true; true",
        // One that brakes, with which nobody was faster before.
        "0.0; 4; \"gap_m: 20, speed_kmh: 50, maneuvers: [{at_s: 3.5, speed_kmh: 0,"
            + " acceleration_mps2: 5}]\"; no_impact: true; true",
        // Beside, on the way out of the way, and behind.
        "0.0; 4; gap_m: 70, speed_kmh: 0, lateral_offset_m: 3.5; no_impact: true; false",
        "0.0; 4; \"gap_m: 50, speed_kmh: 20, maneuvers: [{at_s: 3.6, lateral_offset_m: 9,"
            + " lateral_speed_mps: 3, lateral_acceleration_mps2: 10, shape: linear}]\"; no_impact: true;"
            + " false",
        "0.0; 6; gap_m: 40, speed_kmh: 0, lateral_offset_m: 3.5; no_impact: true; false",
        // Nothing is claimed of an impact, or only of a faster one.
        "0.0; 4; gap_m: 70, speed_kmh: 0; never_brakes: true; false",
        "0.0; 4; gap_m: 70, speed_kmh: 0; maximal_impact_speed_kmh: 20; true",
        "0.0; 4; gap_m: 70, speed_kmh: 0; maximal_impact_speed_kmh: 55; false",
        "0.0; 4; gap_m: 70, speed_kmh: 0; minimal_gap_m: 2; true",
      })
  void aRunIsTooShortWhereTheEgoWouldHitWhatItComesNearerTo(
      double brake, double duration, String actor, String criteria, boolean open) {
    String scenario = scenario("duration_s: " + duration, "{" + actor + "}", criteria);
    Optional<Diagnostic> found = ScenarioJudge.openEnd(run(parsed(scenario), brake));
    assertEquals(open, found.isPresent(), found::toString);
    found.ifPresent(
        it -> assertEquals("s.yaml:4:13: simulation.end.open", it.location() + ": " + it.id()));
  }

  @Test
  void whereNothingIsThereNothingIsOpen() {
    String scenario = scenario("duration_s: 4", "", "no_impact: true");
    assertEquals(Optional.empty(), ScenarioJudge.openEnd(run(parsed(scenario), 0.0)));
  }

  @Test
  void whatAScenarioWaitsForIsItsConclusion() {
    String scenario =
        scenario(
            "duration_s: 8\nend_when: ttc < 2 s", "{gap_m: 70, speed_kmh: 0}", "no_impact: true");
    assertEquals(Optional.empty(), ScenarioJudge.openEnd(run(parsed(scenario), 0.0)));
  }

  @Test
  void whatIsClaimedOfImpactsIsItsConsequence() throws IOException {
    Scenario scenario =
        parsed(
            scenario(
                "duration_s: 4", "{gap_m: 70, speed_kmh: 0}", "no_impact: true, minimal_gap_m: 1"));
    ScenarioJudge judge =
        new ScenarioJudge(
            new AebProject(folder).request(List.of(scenario)).simulatedChain(), List.of(), false);
    List<CriterionResult> about = judge.criteria(run(scenario, 0.1), true).subList(0, 2);
    for (CriterionResult each : about) {
      assertTrue(!each.tested(), each::toString);
      assertTrue(each.measured().contains("s before the ego would hit car 1"), each::measured);
      assertEquals("s.yaml:4:13", each.cause().orElseThrow().location().toString());
    }
  }

  /** The stop trigger of an OpenSCENARIO file is the place to change. */
  @Test
  void aStopTriggerThatComesTooSoonIsNamed() throws IOException {
    String file = Files.readString(FILES.resolve("rear-end.xosc"));
    String tooSoon =
        file.replaceFirst(
            "(?s)<ByEntityCondition>\\s*<TriggeringEntities[^>]*>\\s*<EntityRef"
                + " entityRef=\"Ego\"/>\\s*</TriggeringEntities>\\s*<EntityCondition>\\s*"
                + "<StandStillCondition.*?</ByEntityCondition>",
            "<ByValueCondition><SimulationTimeCondition value=\"2\" rule=\"greaterThan\"/>"
                + "</ByValueCondition>");
    Files.createDirectory(folder.resolve("catalogs"));
    for (String other : List.of("straight.xodr", "catalogs/vehicles.xosc")) {
      Files.copy(FILES.resolve(other), folder.resolve(other));
    }
    Path copy = Files.writeString(folder.resolve("too-soon.xosc"), tooSoon);
    List<Scenario> read =
        Scenario.readFiles(List.of(copy), List.of("no_impact"), Bench.carla(), warning -> {});
    Diagnostic found = ScenarioJudge.openEnd(run(read.get(0), 0.0)).orElseThrow();
    assertTrue(found.location().toString().endsWith("too-soon.xosc:109:5"), found::toString);
    assertTrue(found.message().contains("came nearer to Target"), found::message);
    List<Scenario> good =
        Scenario.readFiles(
            List.of(FILES.resolve("rear-end.xosc")),
            List.of("no_impact"),
            Bench.carla(),
            warning -> {});
    assertEquals(Optional.empty(), ScenarioJudge.openEnd(run(good.get(0), 1.0)));
  }

  private static String scenario(String end, String actors, String criteria) {
    return """
        name: approach
        title: An approach
        requirements: [AEB-1]
        %s
        ego: {speed_kmh: 50}
        actors: [%s]
        accept: {%s}
        """
        .formatted(end, actors, criteria);
  }

  private static Scenario parsed(String scenario) {
    return Scenario.parse(SourceText.of("s.yaml", scenario), Bench.carla());
  }

  private static ScenarioRun run(Scenario scenario, double brake) {
    World world = WorldRuns.start(scenario);
    world.command(0, VehicleCommand.brake(brake));
    world.advanceTo(World.nanoseconds(scenario.duration()));
    return WorldRuns.of(scenario, world);
  }
}
