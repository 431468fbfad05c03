package dev.eventchain.simulation;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.chain.SimulatedChain;
import dev.eventchain.simulation.fault.FaultPlan;
import dev.eventchain.simulation.host.UserFiles;
import dev.eventchain.simulation.node.DdsAttachment;
import dev.eventchain.simulation.node.NodeLimits;
import dev.eventchain.simulation.node.NodeManifest;
import dev.eventchain.simulation.node.NodePackage;
import dev.eventchain.simulation.scenario.Scenario;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;

/**
 * What to simulate.
 *
 * @param chain the chain whose nodes were generated
 * @param packageFolder the folder that holds the manifest and the generated Python package
 * @param manifest what was generated
 * @param messageFolders folders with the user's message definitions, {@code <package>/msg/*.msg}
 * @param bench how the world and the nodes are connected
 * @param scenarios at least one
 * @param processes how many scenarios are simulated at the same time, at least 1; the result does
 *     not depend on it
 * @param generated names of the components that were generated and have to keep to the rules of
 *     such; the others are people's own
 * @param limits what the nodes and their components may use
 * @param accepted whether people have decided to live with a finding: a component that did not work
 *     keeps criteria from being judged only if they have not
 * @param recordings an existing folder that gets the messages of each scenario, in {@code
 *     NAME.mcap} once the scenario has ended, also by a failure of a node; empty: nothing is
 *     recorded
 * @param driver how the nodes are run
 * @param faults what else is simulated: each fault in one more run of its scenario, which is one of
 *     the scenarios
 * @param attachment where to find the nodes that are run elsewhere; there with {@link
 *     SimulationDriver#DDS_ATTACHED} only
 */
public record SimulationRequest(
    EventChain chain,
    Path packageFolder,
    NodeManifest manifest,
    List<Path> messageFolders,
    Bench bench,
    List<Scenario> scenarios,
    int processes,
    Set<String> generated,
    NodeLimits limits,
    Predicate<Diagnostic> accepted,
    Optional<Path> recordings,
    SimulationDriver driver,
    FaultPlan faults,
    Optional<DdsAttachment> attachment) {

  /** Copies the lists; refuses a request without scenario or process. */
  public SimulationRequest {
    messageFolders = List.copyOf(messageFolders);
    scenarios = List.copyOf(scenarios);
    generated = Set.copyOf(generated);
    if (scenarios.isEmpty() || processes < 1) {
      throw new IllegalArgumentException("a simulation needs a scenario and a process");
    }
    if (attachment.isPresent() != (driver == SimulationDriver.DDS_ATTACHED)) {
      throw new IllegalArgumentException("attaching needs a domain");
    }
  }

  /** With two processes and the default limits; no component counts as generated. */
  public static SimulationRequest of(
      EventChain chain,
      Path packageFolder,
      NodeManifest manifest,
      List<Path> messageFolders,
      Bench bench,
      List<Scenario> scenarios) {
    return new SimulationRequest(
        chain,
        packageFolder,
        manifest,
        messageFolders,
        bench,
        scenarios,
        2,
        Set.of(),
        NodeLimits.DEFAULT,
        finding -> false,
        Optional.empty(),
        SimulationDriver.LOCKSTEP,
        FaultPlan.NONE,
        Optional.empty());
  }

  /** The same on another number of processes. */
  public SimulationRequest withProcesses(int number) {
    return with(number, generated, limits, accepted, recordings, driver, faults, attachment);
  }

  /** The same with other components that count as generated. */
  public SimulationRequest withGenerated(Set<String> names) {
    return with(processes, names, limits, accepted, recordings, driver, faults, attachment);
  }

  /** The same with other limits. */
  public SimulationRequest withLimits(NodeLimits other) {
    return with(processes, generated, other, accepted, recordings, driver, faults, attachment);
  }

  /** The same with other findings that people accept. */
  public SimulationRequest withAccepted(Predicate<Diagnostic> other) {
    return with(processes, generated, limits, other, recordings, driver, faults, attachment);
  }

  /** The same with recordings in a folder, which exists. */
  public SimulationRequest withRecordings(Path folder) {
    return with(
        processes, generated, limits, accepted, Optional.of(folder), driver, faults, attachment);
  }

  /** The same with another driver, which starts the nodes. */
  public SimulationRequest withDriver(SimulationDriver other) {
    return with(
        processes, generated, limits, accepted, recordings, other, faults, Optional.empty());
  }

  /** The same with faults, each in a scenario of this request. */
  public SimulationRequest withFaults(FaultPlan other) {
    return with(processes, generated, limits, accepted, recordings, driver, other, attachment);
  }

  /** The same with nodes that are run elsewhere. */
  public SimulationRequest withAttachment(DdsAttachment where) {
    return with(
        1,
        generated,
        limits,
        accepted,
        recordings,
        SimulationDriver.DDS_ATTACHED,
        faults,
        Optional.of(where));
  }

  /** For people: what brings messages from one node to another. */
  String driverWords() {
    return driver.words() + attachment.map(it -> " to domain " + it.domain()).orElse("");
  }

  /** Whether the nodes are run elsewhere, so that what happens inside is not visible. */
  boolean isAttached() {
    return driver == SimulationDriver.DDS_ATTACHED;
  }

  /** The files that the user's code is in. */
  UserFiles userFiles() {
    return new UserFiles(packageFolder);
  }

  /**
   * The generated nodes, with the user's message definitions in a file.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException a definition is wrong, or the file
   *     cannot be written ({@code python.unavailable})
   */
  public NodePackage nodePackage() {
    return new NodePackage(
        packageFolder, manifest, MessageFile.of(messageFolders), generated, limits);
  }

  /**
   * What of the chain is simulated.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException (INPUT) if the manifest is not that of
   *     the chain ({@code simulation.manifest})
   */
  public SimulatedChain simulatedChain() {
    MessageCatalog catalog = MessageCatalog.of(messageFolders);
    manifest.requireNodesOf(packageFolder, chain, SimulatedChain.components(chain));
    return new SimulatedChain(chain, bench, catalog, isAttached());
  }

  private SimulationRequest with(
      int number,
      Set<String> names,
      NodeLimits newLimits,
      Predicate<Diagnostic> newAccepted,
      Optional<Path> newRecordings,
      SimulationDriver newDriver,
      FaultPlan newFaults,
      Optional<DdsAttachment> newAttachment) {
    return new SimulationRequest(
        chain,
        packageFolder,
        manifest,
        messageFolders,
        bench,
        scenarios,
        number,
        names,
        newLimits,
        newAccepted,
        newRecordings,
        newDriver,
        newFaults,
        newAttachment);
  }
}
