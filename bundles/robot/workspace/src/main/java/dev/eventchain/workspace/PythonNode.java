package dev.eventchain.workspace;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Map;
import java.util.Optional;

/**
 * The class of a node in Python, and how it is launched.
 *
 * @param module its module, with its packages
 * @param name the name that a launch file gives it; empty for its own
 * @param namespace the namespace that a launch file gives it; empty for its own
 * @param remappings full names of topics by the names that it uses
 * @param arguments what it is made with, an object by the names of parameters; empty for what the
 *     file of its class says
 * @param parameters values that a launch file gives its parameters of ROS 2, by their names
 */
public record PythonNode(
    String module,
    String className,
    String name,
    String namespace,
    Map<String, String> remappings,
    Optional<JsonNode> arguments,
    Map<String, JsonNode> parameters) {

  /** Returns the file of the module, below the folder from which it is imported. */
  String file() {
    return file(module);
  }

  static String file(String module) {
    return module.replace('.', '/') + ".py";
  }
}
