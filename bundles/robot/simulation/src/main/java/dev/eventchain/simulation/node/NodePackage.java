package dev.eventchain.simulation.node;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;

/**
 * The Python package of the generated nodes, and what they may use.
 *
 * @param folder holds the manifest and the package
 * @param manifest what was generated
 * @param messageFolders folders with the user's message definitions
 * @param restricted names of the components that have to keep to the rules of generated ones
 * @param limits of the nodes and their components
 */
public record NodePackage(
    Path folder,
    NodeManifest manifest,
    List<Path> messageFolders,
    Set<String> restricted,
    NodeLimits limits) {

  /**
   * Refuses a manifest that is not that of a chain.
   *
   * @param components those of the chain that are to be run
   * @throws DiagnosticException (INPUT) {@code simulation.manifest}
   */
  public void requireNodesOf(EventChain chain, List<SoftwareNode> components) {
    List<Diagnostic> problems = manifest.problems(chain, folder, components);
    if (!problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, problems);
    }
  }
}
