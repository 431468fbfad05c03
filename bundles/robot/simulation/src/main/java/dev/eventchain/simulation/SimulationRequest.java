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
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;

/**
 * Request for a simulation.
 *
 * @param chain the chain whose nodes were generated
 * @param packageFolder the folder that holds the manifest and the generated Python package
 * @param manifest the generated nodes
 * @param messageFolders folders with the user's message definitions, {@code <package>/msg/*.msg}
 * @param bench the connection of the world with the nodes
 * @param scenarios at least one
 * @param processes number of scenarios simulated in parallel, at least 1; the result does not
 *     depend on it
 * @param generated names of the generated components, which must follow the rules for generated
 *     code; the others are handwritten
 * @param limits the resources that the nodes and their components may use
 * @param accepted predicate of accepted findings: a component that did not work keeps criteria from
 *     being judged unless its finding is accepted
 * @param recordings an existing folder that gets the messages of each scenario, in {@code
 *     NAME.mcap} once the scenario has ended, also by a failure of a node; empty: nothing is
 *     recorded
 * @param driver the driver of the nodes
 * @param faults the faults to inject, each in an additional run of one of the scenarios
 * @param strength true to measure the strength of requirements, if every scenario passes
 * @param complete false if the project has more scenarios, in which components may do what they do
 *     not do in these
 * @param attachment the DDS domain of the nodes; with {@link SimulationDriver#DDS_ATTACHED} only
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
    boolean strength,
    boolean complete,
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

  /**
   * Returns a request with two processes and the default limits; no component counts as generated.
   */
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
        false,
        true,
        Optional.empty());
  }

  /** Returns a copy with another number of processes. */
  public SimulationRequest withProcesses(int number) {
    return with(
        number,
        generated,
        limits,
        accepted,
        recordings,
        driver,
        faults,
        strength,
        complete,
        attachment);
  }

  /** Returns a copy with other components that count as generated. */
  public SimulationRequest withGenerated(Set<String> names) {
    return with(
        processes,
        names,
        limits,
        accepted,
        recordings,
        driver,
        faults,
        strength,
        complete,
        attachment);
  }

  /** Returns a copy with other limits. */
  public SimulationRequest withLimits(NodeLimits other) {
    return with(
        processes,
        generated,
        other,
        accepted,
        recordings,
        driver,
        faults,
        strength,
        complete,
        attachment);
  }

  /** Returns a copy with other accepted findings. */
  public SimulationRequest withAccepted(Predicate<Diagnostic> other) {
    return with(
        processes,
        generated,
        limits,
        other,
        recordings,
        driver,
        faults,
        strength,
        complete,
        attachment);
  }

  /** Returns a copy with recordings in an existing folder. */
  public SimulationRequest withRecordings(Path folder) {
    return with(
        processes,
        generated,
        limits,
        accepted,
        Optional.of(folder),
        driver,
        faults,
        strength,
        complete,
        attachment);
  }

  /** Returns a copy with another driver, which starts the nodes. */
  public SimulationRequest withDriver(SimulationDriver other) {
    return with(
        processes,
        generated,
        limits,
        accepted,
        recordings,
        other,
        faults,
        strength,
        complete,
        Optional.empty());
  }

  /** Returns a copy with faults, each in a scenario of this request. */
  public SimulationRequest withFaults(FaultPlan other) {
    return with(
        processes,
        generated,
        limits,
        accepted,
        recordings,
        driver,
        other,
        strength,
        complete,
        attachment);
  }

  /** Returns a copy that measures the strength of requirements or not. */
  public SimulationRequest withStrength(boolean measured) {
    return with(
        processes,
        generated,
        limits,
        accepted,
        recordings,
        driver,
        faults,
        measured,
        complete,
        attachment);
  }

  /** Returns a copy with some scenarios of a project, or all of them. */
  public SimulationRequest ofAllScenarios(boolean all) {
    return with(
        processes,
        generated,
        limits,
        accepted,
        recordings,
        driver,
        faults,
        strength,
        all,
        attachment);
  }

  /** Returns whether it measures the strength of requirements, which needs lock-step. */
  boolean measuresStrength() {
    return strength && driver == SimulationDriver.LOCKSTEP;
  }

  /** Returns a copy with nodes that run elsewhere. */
  public SimulationRequest withAttachment(DdsAttachment where) {
    return with(
        1,
        generated,
        limits,
        accepted,
        recordings,
        SimulationDriver.DDS_ATTACHED,
        faults,
        strength,
        complete,
        Optional.of(where));
  }

  /** Returns the description of the driver for users. */
  String driverWords() {
    return driver.words() + attachment.map(it -> " to domain " + it.domain()).orElse("");
  }

  /** Returns whether the nodes run elsewhere, so that their activations are not visible. */
  boolean isAttached() {
    return driver == SimulationDriver.DDS_ATTACHED;
  }

  /** Returns the files with the user's code. */
  UserFiles userFiles() {
    return new UserFiles(packageFolder);
  }

  /**
   * Returns the generated nodes, with the user's message definitions in a file.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException a definition is wrong, or the file
   *     cannot be written ({@code python.unavailable})
   */
  public NodePackage nodePackage() {
    return new NodePackage(
        packageFolder,
        manifest,
        MessageFile.of(messageFolders),
        generated,
        limits,
        List.of(),
        Map.of());
  }

  /**
   * Returns the simulated part of the chain.
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
      boolean newStrength,
      boolean newComplete,
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
        newStrength,
        newComplete,
        newAttachment);
  }
}
