package dev.eventchain.simulation;

import com.fasterxml.jackson.databind.node.MissingNode;
import dev.eventchain.simulation.host.RunLog;
import dev.eventchain.simulation.run.OutputRecord;
import dev.eventchain.simulation.run.ScenarioRun;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.world.Trace;
import dev.eventchain.simulation.world.World;
import java.util.List;
import java.util.Map;

/** Runs of scenarios by a world alone, without nodes. */
public final class WorldRuns {

  private WorldRuns() {}

  /** Returns the world of a scenario at its start. */
  public static World start(Scenario scenario) {
    return new World(
        scenario.situation(), new Trace(scenario.inputs(), scenario.situation().road()));
  }

  /** Returns what happened in a world as the run of its scenario. */
  public static ScenarioRun of(Scenario scenario, World world) {
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
