package dev.eventchain.workspace;

import java.util.Map;

/**
 * The class of a node in Python, and how it is launched.
 *
 * @param module its module, with its packages
 * @param name the name that a launch file gives it; empty for its own
 * @param namespace the namespace that a launch file gives it; empty for its own
 * @param remappings full names of topics by the names that it uses
 */
public record PythonNode(
    String module,
    String className,
    String name,
    String namespace,
    Map<String, String> remappings) {

  /** Returns the file of the module, below the folder from which it is imported. */
  String file() {
    return file(module);
  }

  static String file(String module) {
    return module.replace('.', '/') + ".py";
  }
}
