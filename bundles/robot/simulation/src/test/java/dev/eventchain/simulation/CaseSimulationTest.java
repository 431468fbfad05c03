package dev.eventchain.simulation;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.judge.ScenarioJudge;
import dev.eventchain.simulation.run.ScenarioRun;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.CaseResult.Label;
import dev.eventchain.simulation.world.VehicleCommand;
import dev.eventchain.simulation.world.World;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests how cases are judged in which nothing comes into the ego's way. */
class CaseSimulationTest {

  @TempDir Path folder;

  /** A car that waits for something that never comes might have been in the way. */
  @ParameterizedTest
  @CsvSource({
    "no_impact: true, 0, PASSED",
    "maximal_impact_speed_kmh: 10, 0, PASSED",
    "minimal_gap_m: 1, 0, UNTESTED",
    "no_impact: true, 99, UNTESTED",
    "maximal_impact_speed_kmh: 10, 99, UNTESTED"
  })
  void withoutAnythingAheadThereIsNoImpact(String criterion, double speed, Label label)
      throws Exception {
    Scenario scenario =
        Scenario.parse(
            SourceText.of(
                "s.yaml",
                """
                name: empty
                title: A car in the next lane
                duration_s: 5
                ego: {speed_kmh: 50}
                actors:
                  - gap_m: 120
                    speed_kmh: 50
                    lateral_offset_m: 3.5
                    maneuvers: [{when: ego.speed >= %s m/s, speed_kmh: 60, acceleration_mps2: 1}]
                accept: {%s}
                """
                    .formatted(speed, criterion)),
            Bench.carla());
    ScenarioJudge judge =
        new ScenarioJudge(
            new AebProject(folder).request(List.of(scenario)).simulatedChain(), List.of(), false);
    assertEquals(label, CaseSimulation.judged(judge, braking(scenario)).label());
  }

  private static ScenarioRun braking(Scenario scenario) {
    World world = WorldRuns.start(scenario);
    for (double time = 0; time < scenario.duration(); time += 0.5) {
      world.advanceTo(World.nanoseconds(time));
      world.command(world.now(), VehicleCommand.brake(0.1));
    }
    world.advanceTo(World.nanoseconds(scenario.duration()));
    return WorldRuns.of(scenario, world);
  }
}
