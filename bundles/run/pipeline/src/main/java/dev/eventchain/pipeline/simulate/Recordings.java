package dev.eventchain.pipeline.simulate;

import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.simulation.SimulationRequest;
import dev.eventchain.simulation.scenario.Scenario;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * Recordings of scenarios, one file each, since all of them begin at time 0. Each is from the last
 * simulation of its scenario: older ones are deleted when a simulation starts, with or without new
 * ones.
 */
final class Recordings {

  private static final String FOLDER = "mcap";
  private static final String SUFFIX = ".mcap";

  private final RunContext run;
  private final List<String> scenarios;

  Recordings(RunContext run, List<Scenario> scenarios) {
    this.run = run;
    this.scenarios = scenarios.stream().map(Scenario::name).toList();
  }

  /**
   * Deletes the recordings that the simulation makes obsolete, and requests new ones if configured.
   */
  SimulationRequest begin(SimulationRequest request) {
    if (run.options().isPartial()) {
      scenarios.forEach(name -> run.output().removeAll(nameOf(name)));
    } else {
      run.output().removeAll(FOLDER);
    }
    return run.options().mcap()
        ? request.with(it -> it.withRecordings(run.output().scratch()))
        : request;
  }

  /** Moves complete recordings into place, whatever the result of the scenarios. */
  void keep() {
    if (!run.options().mcap()) {
      return;
    }
    Path scratch = run.output().scratch();
    for (String name : scenarios) {
      Path finished = scratch.resolve(name + SUFFIX);
      if (Files.isRegularFile(finished)) {
        run.output().move(finished, nameOf(name)).finding().ifPresent(run::find);
        run.recorded(run.file(nameOf(name)));
      }
    }
  }

  private static String nameOf(String scenario) {
    return FOLDER + "/" + scenario + SUFFIX;
  }
}
