package dev.eventchain.workspace;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * A node as it is started.
 *
 * @param name the full name, with its namespace
 * @param description what it says about itself; may be empty
 * @param frequency in Hz, of its timer; empty without one
 * @param isComplete whether all of its endpoints are known
 * @param python its class, if it is one in Python
 * @param file the file that defines it, relative to the workspace
 */
public record FoundNode(
    String name,
    String description,
    OptionalDouble frequency,
    List<FoundEndpoint> endpoints,
    boolean isComplete,
    Optional<PythonNode> python,
    String file,
    int line) {}
