package dev.eventchain.simulation.judge;

import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.node.MissingNode;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.simulation.AebProject;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.host.RunLog;
import dev.eventchain.simulation.run.OutputRecord;
import dev.eventchain.simulation.run.ScenarioRun;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.ScenarioVerdict.CriterionResult;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.VehicleCommand;
import dev.eventchain.simulation.world.World;
import java.lang.ref.WeakReference;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests what a judge keeps of the runs that it judges. */
class ScenarioJudgeTest {

  @TempDir Path folder;

  /** Mutation testing judges thousands of runs with one judge. */
  @Test
  void aJudgedRunIsNotKept() throws Exception {
    AebProject project = new AebProject(folder);
    Scenario scenario = AebProject.scenario("stopped-vehicle-50");
    ScenarioJudge judge =
        new ScenarioJudge(project.request(List.of(scenario)).simulatedChain(), List.of(), false);
    WeakReference<Trace> judged = judged(judge, scenario);
    for (int i = 0; i < 100 && judged.get() != null; i++) {
      System.gc();
      Thread.sleep(10);
    }
    assertNull(judged.get());
  }

  @Test
  void nothingIsTestedWhereAManeuverNeverBegan() throws Exception {
    List<CriterionResult> met = brakingWhile("", "ego.speed < 12 m/s");
    assertTrue(met.stream().anyMatch(CriterionResult::passed), met::toString);
    List<CriterionResult> never = brakingWhile("", "ego.speed > 99 m/s");
    assertTrue(
        never.subList(0, 2).stream().allMatch(each -> each.measured().contains(NEVER)),
        never::toString);
    List<CriterionResult> optional = brakingWhile(", optional: true", "ego.speed > 99 m/s");
    assertTrue(optional.stream().anyMatch(CriterionResult::passed), optional::toString);
  }

  private static final String NEVER = "never began: that of car 1 when ego.speed > 99 m/s";

  /** Brakes at once before a car that waits for something. */
  private List<CriterionResult> brakingWhile(String optional, String when) throws Exception {
    String scenario =
        """
        name: waiting
        title: A car waits
        requirements: [AEB-1]
        duration_s: 8
        ego: {speed_kmh: 50}
        actors:
          - gap_m: 60
            speed_kmh: 0
            maneuvers: [{when: %s, speed_kmh: 3, acceleration_mps2: 1%s}]
        accept: {no_impact: true, stops: true}
        """
            .formatted(when, optional);
    Scenario read = Scenario.parse(SourceText.of("s.yaml", scenario), Bench.carla());
    Path project = Files.createTempDirectory(folder, "waiting");
    ScenarioJudge judge =
        new ScenarioJudge(
            new AebProject(project).request(List.of(read)).simulatedChain(), List.of(), false);
    return judge.criteria(braking(read), true);
  }

  /** Judges a run that brakes at once, so that the criteria on impact and standstill hold. */
  private static WeakReference<Trace> judged(ScenarioJudge judge, Scenario scenario) {
    ScenarioRun run = braking(scenario);
    // Only for such criteria does the judge look at what the vehicle does without software.
    assertTrue(
        judge.criteria(run, true).stream()
            .filter(CriterionResult::passed)
            .anyMatch(each -> !each.requirements().isEmpty()));
    return new WeakReference<>(run.trace());
  }

  private static ScenarioRun braking(Scenario scenario) {
    World world =
        new World(scenario.situation(), new Trace(scenario.inputs(), scenario.situation().road()));
    world.command(0, VehicleCommand.brake(1.0));
    world.advanceTo(World.nanoseconds(scenario.duration()));
    return new ScenarioRun(
        scenario,
        world.trace(),
        new RunLog(Map.of(), Map.of()),
        MissingNode.getInstance(),
        Map.of(),
        List.of(),
        new OutputRecord(Map.of()),
        List.of(),
        0,
        0);
  }
}
