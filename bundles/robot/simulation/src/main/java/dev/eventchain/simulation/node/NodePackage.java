package dev.eventchain.simulation.node;

import java.nio.file.Path;
import java.util.Set;

/**
 * The Python package of the generated nodes, with their limits.
 *
 * @param folder holds the manifest and the package
 * @param manifest the generated nodes
 * @param messages the file with the user's message definitions, as the runtime reads them
 * @param restricted names of the components that must follow the rules for generated code
 * @param limits the limits of the nodes and their components
 */
public record NodePackage(
    Path folder, NodeManifest manifest, Path messages, Set<String> restricted, NodeLimits limits) {}
