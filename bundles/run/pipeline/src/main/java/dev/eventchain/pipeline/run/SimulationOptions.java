package dev.eventchain.pipeline.run;

import dev.eventchain.pipeline.project.StrengthExtent;
import java.nio.file.Path;
import java.util.Optional;

/**
 * Options of the simulation in a run.
 *
 * @param scenarios those to simulate
 * @param driver the driver of the simulated nodes
 * @param mcap true to record the messages of the scenarios, too
 * @param faults a file of faults for additional simulations of the scenarios
 * @param strength how far to measure the strength of requirements; empty: as the project says
 */
public record SimulationOptions(
    ScenarioSelection scenarios,
    Driver driver,
    boolean mcap,
    Optional<Path> faults,
    Optional<StrengthExtent> strength) {

  /** Options for all scenarios, in lock-step, with the strength that the project wants. */
  public static final SimulationOptions DEFAULT =
      new SimulationOptions(
          ScenarioSelection.ALL, Driver.LOCKSTEP, false, Optional.empty(), Optional.empty());

  /** Drivers of the nodes: they transport messages and advance time. */
  public enum Driver {
    /** All nodes in one process, with messages in memory. */
    LOCKSTEP,
    /** Each node in its own process on Cyclone DDS, in simulated time. */
    DDS,
    /** The same in real time. */
    DDS_IN_REAL_TIME,
    /** Nodes started elsewhere, in the DDS domain of the environment, in real time. */
    DDS_ATTACHED
  }

  /** Returns options with another extent of strength. */
  public SimulationOptions with(StrengthExtent extent) {
    return new SimulationOptions(scenarios, driver, mcap, faults, Optional.of(extent));
  }

  /** Returns whether the nodes run elsewhere, so that changes in them are unknown. */
  public boolean isAttached() {
    return driver == Driver.DDS_ATTACHED;
  }

  /** Returns whether scenarios are simulated even if nothing has changed here. */
  public boolean simulatesAnyway() {
    return mcap || isAttached();
  }
}
