package dev.eventchain.simulation.node;

import java.nio.file.Path;
import java.util.List;
import java.util.Set;

/**
 * The Python package of the generated nodes, with their limits.
 *
 * @param folder holds the manifest and the package
 * @param manifest the generated nodes
 * @param messages the file with the user's message definitions, as the runtime reads them
 * @param restricted names of the components that must follow the rules for generated code
 * @param limits the limits of the nodes and their components
 * @param variants folders with other versions of components
 * @param replaced the files in these folders that are loaded instead of those of the package
 */
public record NodePackage(
    Path folder,
    NodeManifest manifest,
    Path messages,
    Set<String> restricted,
    NodeLimits limits,
    List<Path> variants,
    Replacements replaced) {

  /** Copies the collections. */
  public NodePackage {
    restricted = Set.copyOf(restricted);
    variants = List.copyOf(variants);
  }

  /** Returns the file of a node's component. */
  public Path componentFile(NodeManifest.Node node, NodeManifest.Component component) {
    return replaced.files().getOrDefault(node.name(), folder.resolve(component.file()));
  }

  /** Returns the file of the module of a node that is hosted as it is. */
  public Path nodeFile(NodeManifest.Node node) {
    return folder.resolve(NodeManifest.NODES).resolve(NodeManifest.file(node.module()));
  }

  /** Returns a copy whose processes may read a folder with other versions of components. */
  public NodePackage withVariants(Path from) {
    return new NodePackage(folder, manifest, messages, restricted, limits, List.of(from), replaced);
  }

  /** Returns a copy that loads other files. */
  public NodePackage with(Replacements files) {
    return new NodePackage(
        folder, manifest, messages, restricted, limits, variants, replaced.with(files));
  }
}
