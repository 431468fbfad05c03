package dev.eventchain.maven;

import dev.eventchain.pipeline.Outcome;
import dev.eventchain.pipeline.run.ScenarioSelection;
import dev.eventchain.pipeline.run.SimulationOptions;
import dev.eventchain.pipeline.run.SimulationOptions.Driver;
import dev.eventchain.pipeline.run.Stage;
import java.io.File;
import java.nio.file.Path;
import java.util.Optional;
import org.apache.maven.plugins.annotations.LifecyclePhase;
import org.apache.maven.plugins.annotations.Mojo;
import org.apache.maven.plugins.annotations.Parameter;

/** Simulates all scenarios of an event chain, and fails the build unless the verdict is PASSED. */
@Mojo(name = "simulate", defaultPhase = LifecyclePhase.INTEGRATION_TEST)
public class SimulateMojo extends ChainMojo {

  /**
   * The driver of the nodes: {@code LOCKSTEP}, all in one process, or {@code DDS}, each in a
   * separate process with Cyclone DDS between them; {@code DDS_IN_REAL_TIME} lets them run in
   * wall-clock time, and {@code DDS_ATTACHED} drives nodes that were started elsewhere.
   */
  @Parameter(property = "eventchain.driver", defaultValue = "LOCKSTEP")
  private Driver driver;

  /** File of faults for additional simulations of the scenarios. */
  @Parameter(property = "eventchain.faults")
  private File faults;

  @Override
  Outcome work() {
    return simulate(Stage.SIMULATE);
  }

  final Outcome simulate(Stage last) {
    Path folder = chain().orElseGet(() -> Places.shown(basedir()));
    Optional<Path> file = Optional.ofNullable(faults).map(Places::shown);
    return run(
        folder,
        last,
        new SimulationOptions(ScenarioSelection.ALL, driver, false, file, Optional.empty()));
  }
}
