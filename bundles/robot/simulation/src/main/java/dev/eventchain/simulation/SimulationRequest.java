package dev.eventchain.simulation;

import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.chain.SimulatedChain;
import dev.eventchain.simulation.host.UserFiles;
import dev.eventchain.simulation.node.NodeManifest;
import dev.eventchain.simulation.node.NodePackage;
import dev.eventchain.simulation.node.Replacements;
import dev.eventchain.simulation.scenario.Scenario;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;

/**
 * Request for a simulation.
 *
 * @param chain the chain whose nodes were generated
 * @param packageFolder the folder that holds the manifest and the generated Python package
 * @param manifest the generated nodes
 * @param messages the definitions of the messages, the standard ones and the user's
 * @param bench the connection of the world with the nodes
 * @param scenarios at least one
 * @param settings how the nodes run, and what is measured
 */
public record SimulationRequest(
    EventChain chain,
    Path packageFolder,
    NodeManifest manifest,
    MessageCatalog messages,
    Bench bench,
    List<Scenario> scenarios,
    SimulationSettings settings) {

  /** Copies the lists; refuses a request without scenario. */
  public SimulationRequest {
    scenarios = List.copyOf(scenarios);
    if (scenarios.isEmpty()) {
      throw new IllegalArgumentException("a simulation needs a scenario");
    }
  }

  /** Returns a request with the default settings. */
  public static SimulationRequest of(
      EventChain chain,
      Path packageFolder,
      NodeManifest manifest,
      MessageCatalog messages,
      Bench bench,
      List<Scenario> scenarios) {
    return new SimulationRequest(
        chain, packageFolder, manifest, messages, bench, scenarios, SimulationSettings.DEFAULT);
  }

  /** Returns a copy with changed settings. */
  public SimulationRequest with(UnaryOperator<SimulationSettings> change) {
    return new SimulationRequest(
        chain, packageFolder, manifest, messages, bench, scenarios, change.apply(settings));
  }

  /** Returns a copy with another bench. */
  public SimulationRequest on(Bench other) {
    return new SimulationRequest(
        chain, packageFolder, manifest, messages, other, scenarios, settings);
  }

  /** Returns the description of the driver for users. */
  String driverWords() {
    return settings.driver().words()
        + settings.attachment().map(it -> " to domain " + it.domain()).orElse("");
  }

  /** Returns whether the nodes run elsewhere, so that their activations are not visible. */
  boolean isAttached() {
    return settings.driver() == SimulationDriver.DDS_ATTACHED;
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
        MessageFile.of(messages),
        settings.generated(),
        settings.limits(),
        List.of(),
        Replacements.NONE);
  }

  /**
   * Returns the simulated part of the chain.
   *
   * @throws dev.eventchain.diagnostics.DiagnosticException (INPUT) if the manifest is not that of
   *     the chain ({@code simulation.manifest})
   */
  public SimulatedChain simulatedChain() {
    manifest.requireNodesOf(packageFolder, chain, SimulatedChain.components(chain));
    Set<String> hosted =
        manifest.nodes().stream()
            .filter(node -> node.component().isEmpty())
            .map(NodeManifest.Node::name)
            .collect(Collectors.toSet());
    return new SimulatedChain(chain, bench, messages, isAttached(), hosted);
  }
}
