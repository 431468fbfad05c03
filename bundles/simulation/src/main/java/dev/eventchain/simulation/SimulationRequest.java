package dev.eventchain.simulation;

import dev.eventchain.metamodel.eventchain.EventChain;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;

/**
 * What to simulate.
 *
 * @param chain the chain whose nodes were generated
 * @param packageFolder the folder that holds the manifest and the generated Python package
 * @param manifest what was generated
 * @param messageFolders folders with the user's message definitions, {@code <package>/msg/*.msg}
 * @param scenarios at least one
 * @param processes how many scenarios are simulated at the same time, at least 1; the result does
 *     not depend on it
 * @param stepLimit time on this machine that the nodes may take for 50 ms of simulated time before
 *     they count as hanging
 */
public record SimulationRequest(
    EventChain chain,
    Path packageFolder,
    NodeManifest manifest,
    List<Path> messageFolders,
    List<Scenario> scenarios,
    int processes,
    Duration stepLimit) {

  /** Copies the lists; refuses a request without scenario or process. */
  public SimulationRequest {
    messageFolders = List.copyOf(messageFolders);
    scenarios = List.copyOf(scenarios);
    if (scenarios.isEmpty() || processes < 1) {
      throw new IllegalArgumentException("a simulation needs a scenario and a process");
    }
  }

  /** With two processes and a limit of ten seconds. */
  public static SimulationRequest of(
      EventChain chain,
      Path packageFolder,
      NodeManifest manifest,
      List<Path> messageFolders,
      List<Scenario> scenarios) {
    return new SimulationRequest(
        chain, packageFolder, manifest, messageFolders, scenarios, 2, Duration.ofSeconds(10));
  }

  /** The same on another number of processes. */
  public SimulationRequest withProcesses(int number) {
    return new SimulationRequest(
        chain, packageFolder, manifest, messageFolders, scenarios, number, stepLimit);
  }

  /** The same with another limit. */
  public SimulationRequest withStepLimit(Duration limit) {
    return new SimulationRequest(
        chain, packageFolder, manifest, messageFolders, scenarios, processes, limit);
  }
}
