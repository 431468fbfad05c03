package dev.eventchain.pipeline.simulate;

import dev.eventchain.pipeline.stage.RunContext;
import dev.eventchain.simulation.SimulationRequest;
import dev.eventchain.simulation.fault.Fault;
import dev.eventchain.simulation.fault.FaultPlan;
import dev.eventchain.simulation.scenario.Scenario;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Recordings of scenarios and of their runs with faults, one file each, since all of them begin at
 * time 0. Each is from the last simulation of its scenario: older ones are deleted when a
 * simulation starts, with or without new ones.
 */
final class Recordings {

  private static final String FOLDER = "mcap";
  private static final String SUFFIX = ".mcap";

  private final RunContext run;
  private final List<String> scenarios;
  private final List<String> faults;

  Recordings(RunContext run, List<Scenario> scenarios, FaultPlan faults) {
    this.run = run;
    this.scenarios = scenarios.stream().map(Scenario::name).toList();
    this.faults = faults.faults().stream().map(Fault::recording).toList();
  }

  /**
   * Deletes the recordings that the simulation makes obsolete, and requests new ones if configured.
   */
  SimulationRequest begin(SimulationRequest request) {
    if (run.options().isPartial()) {
      existing()
          .filter(this::isOfThese)
          .forEach(file -> run.output().removeAll(FOLDER + "/" + file));
    } else {
      run.output().removeAll(FOLDER);
    }
    return run.options().simulation().mcap()
        ? request.with(it -> it.withRecordings(run.output().scratch()))
        : request;
  }

  private Stream<String> existing() {
    String[] files = run.file(FOLDER).toFile().list();
    return Optional.ofNullable(files).stream().flatMap(Arrays::stream).sorted();
  }

  /** Returns whether a file is the recording of one of the scenarios, with a fault or without. */
  private boolean isOfThese(String file) {
    return scenarios.stream().anyMatch(scenario -> file.startsWith(scenario + "."));
  }

  /** Moves complete recordings into place, whatever the result of the scenarios. */
  void keep() {
    if (!run.options().simulation().mcap()) {
      return;
    }
    Path scratch = run.output().scratch();
    for (String name : Stream.concat(scenarios.stream(), faults.stream()).toList()) {
      Path finished = scratch.resolve(name + SUFFIX);
      if (Files.isRegularFile(finished)) {
        run.output().move(finished, nameOf(name)).finding().ifPresent(run::find);
        run.recorded(run.file(nameOf(name)));
      }
    }
  }

  private static String nameOf(String recording) {
    return FOLDER + "/" + recording + SUFFIX;
  }
}
