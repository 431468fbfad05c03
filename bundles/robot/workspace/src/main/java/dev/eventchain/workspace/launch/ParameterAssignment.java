package dev.eventchain.workspace.launch;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Optional;

/**
 * Value that launch gives a parameter of the nodes with a name.
 *
 * @param nodes the name of a node, as files of parameters have it, which may have wildcards
 * @param name that of the parameter; empty if any may be given
 * @param value empty if it is not known
 */
public record ParameterAssignment(String nodes, String name, Optional<JsonNode> value) {

  /** The name that each node matches. */
  static final String ALL = "/**";

  /** Returns the assignment of any parameters of any nodes. */
  static ParameterAssignment unknown() {
    return new ParameterAssignment(ALL, "", Optional.empty());
  }

  /** Returns the same for a value that is perhaps not given. */
  ParameterAssignment unsure() {
    return new ParameterAssignment(nodes, name, Optional.empty());
  }
}
