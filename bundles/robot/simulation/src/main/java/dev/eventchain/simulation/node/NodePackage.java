package dev.eventchain.simulation.node;

import java.nio.file.Path;
import java.util.Set;

/**
 * The Python package of the generated nodes, and what they may use.
 *
 * @param folder holds the manifest and the package
 * @param manifest what was generated
 * @param messages the file with the user's message definitions, as the runtime reads them
 * @param restricted names of the components that have to keep to the rules of generated ones
 * @param limits of the nodes and their components
 */
public record NodePackage(
    Path folder, NodeManifest manifest, Path messages, Set<String> restricted, NodeLimits limits) {}
