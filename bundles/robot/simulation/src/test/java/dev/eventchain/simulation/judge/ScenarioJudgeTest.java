package dev.eventchain.simulation.judge;

import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.node.MissingNode;
import dev.eventchain.simulation.AebProject;
import dev.eventchain.simulation.host.RunLog;
import dev.eventchain.simulation.run.OutputRecord;
import dev.eventchain.simulation.run.ScenarioRun;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.verdict.ScenarioVerdict.CriterionResult;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.VehicleCommand;
import dev.eventchain.simulation.world.World;
import java.lang.ref.WeakReference;
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

  /** Judges a run that brakes at once, so that the criteria on impact and standstill hold. */
  private static WeakReference<Trace> judged(ScenarioJudge judge, Scenario scenario) {
    World world =
        new World(scenario.situation(), new Trace(scenario.inputs(), scenario.situation().road()));
    world.command(0, VehicleCommand.brake(1.0));
    world.advanceTo(World.nanoseconds(scenario.duration()));
    ScenarioRun run =
        new ScenarioRun(
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
    // Only for such criteria does the judge look at what the vehicle does without software.
    assertTrue(
        judge.criteria(run, true).stream()
            .filter(CriterionResult::passed)
            .anyMatch(each -> !each.requirements().isEmpty()));
    return new WeakReference<>(world.trace());
  }
}
