package dev.eventchain.pipeline.simulate;

import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.simulation.SimulationRequest;
import dev.eventchain.simulation.scenario.Scenario;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * The recordings of scenarios, one file each: all of them begin at time 0, so that one file of all
 * would mix them up. They are of the last simulation of their scenario: older ones go when a
 * simulation starts, whether it makes new ones or not.
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
   * Removes those that the simulation makes obsolete, and asks it for new ones if they are wanted.
   */
  SimulationRequest begin(SimulationRequest request) {
    if (run.options().isPartial()) {
      scenarios.forEach(name -> run.output().removeAll(nameOf(name)));
    } else {
      run.output().removeAll(FOLDER);
    }
    return run.options().mcap() ? request.withRecordings(run.output().scratch()) : request;
  }

  /** Puts those that are whole in place; whatever happened to the scenarios. */
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
