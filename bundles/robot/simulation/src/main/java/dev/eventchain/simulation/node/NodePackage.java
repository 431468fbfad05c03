package dev.eventchain.simulation.node;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;

/**
 * The Python package of the generated nodes, with their limits.
 *
 * @param folder holds the manifest and the package
 * @param manifest the generated nodes
 * @param messages the file with the user's message definitions, as the runtime reads them
 * @param restricted names of the components that must follow the rules for generated code
 * @param limits the limits of the nodes and their components
 * @param variants folders with other versions of components
 * @param replaced the files in these folders that components, and nodes as they are, are loaded
 *     from instead of their own, by the names of the components
 */
public record NodePackage(
    Path folder,
    NodeManifest manifest,
    Path messages,
    Set<String> restricted,
    NodeLimits limits,
    List<Path> variants,
    Map<String, Path> replaced) {

  /** Copies the collections. */
  public NodePackage {
    restricted = Set.copyOf(restricted);
    variants = List.copyOf(variants);
    replaced = Map.copyOf(replaced);
  }

  /** Returns the file of a node's component. */
  public Path componentFile(NodeManifest.Node node, NodeManifest.Component component) {
    return replaced.getOrDefault(node.name(), folder.resolve(component.file()));
  }

  /** Returns the file of the module of a node that is hosted as it is. */
  public Path nodeFile(NodeManifest.Node node) {
    return folder.resolve(NodeManifest.NODES).resolve(NodeManifest.file(node.module()));
  }

  /** Returns a copy whose processes may read a folder with other versions of components. */
  public NodePackage withVariants(Path from) {
    return new NodePackage(folder, manifest, messages, restricted, limits, List.of(from), replaced);
  }

  /** Returns a copy that loads a component from another file. */
  public NodePackage with(String component, Path file) {
    Map<String, Path> files = new TreeMap<>(replaced);
    files.put(component, file);
    return new NodePackage(folder, manifest, messages, restricted, limits, variants, files);
  }
}
