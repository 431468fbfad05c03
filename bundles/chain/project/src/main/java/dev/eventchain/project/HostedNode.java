package dev.eventchain.project;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeType;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.messages.RosNames;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * A node of rclpy that is hosted as it is.
 *
 * @param root the folder on Python's path from which its module is imported
 * @param module its module, with its packages
 * @param className its class
 * @param name the name that a launch file gives it; empty for its own
 * @param namespace the namespace that a launch file gives it; empty for its own
 * @param remappings full names of topics by the names that it uses
 * @param arguments what it is made with, an object by the names of parameters; empty for what the
 *     file of its class says
 * @param parameters values of its parameters of ROS 2, an object by their names; empty for none
 */
public record HostedNode(
    Path root,
    String module,
    String className,
    String name,
    String namespace,
    Map<String, String> remappings,
    Optional<JsonNode> arguments,
    Optional<JsonNode> parameters) {

  private static final String IDENTIFIER = "[A-Za-z_][A-Za-z0-9_]*";

  /**
   * Reads the description; invalid values are findings of the reader.
   *
   * @param file the file of the module
   */
  static HostedNode read(ObjectReader json, Path file) {
    String className = legal(json, "class", json.requiredText("class"), IDENTIFIER);
    String name = json.text("name").orElse("");
    String namespace = json.text("namespace").orElse("");
    Map<String, String> remappings = new LinkedHashMap<>();
    json.object("remappings")
        .ifPresent(
            pairs -> pairs.names().forEach(from -> remappings.put(from, topic(pairs, from))));
    json.object("arguments").ifPresent(HostedNode::requireNames);
    json.object("parameters").ifPresent(HostedNode::requireValues);
    json.refuseOthers();
    Path root = root(file);
    String path = root.relativize(file).toString().replace('\\', '/');
    String module = path.replaceFirst("\\.py$", "").replace('/', '.');
    return new HostedNode(
        root,
        module,
        className,
        legal(json, "name", name, "(" + IDENTIFIER + ")?"),
        legal(json, "namespace", namespace, "(/|(/" + IDENTIFIER + ")+)?"),
        Map.copyOf(remappings),
        json.value("arguments").filter(JsonNode::isObject),
        json.value("parameters").filter(JsonNode::isObject));
  }

  private static void requireNames(ObjectReader arguments) {
    for (String name : arguments.names()) {
      if (!name.matches(IDENTIFIER)) {
        arguments.find(
            ProjectRules.MODELER_COMPONENT_NODE,
            "'" + name + "' cannot be the name of an argument.",
            arguments.at(name));
      }
    }
  }

  /** Refuses what no parameter can be: an object, nothing, or a list of lists or of both. */
  private static void requireValues(ObjectReader parameters) {
    for (String name : parameters.names()) {
      Optional<JsonNode> value = parameters.value(name);
      boolean legal = value.filter(each -> each.isValueNode() || isList(each)).isPresent();
      if (!legal) {
        parameters.find(
            ProjectRules.MODELER_COMPONENT_NODE,
            "The parameter '" + name + "' cannot have this value.",
            parameters.at(name));
      }
    }
  }

  private static boolean isList(JsonNode value) {
    Set<JsonNodeType> types = EnumSet.noneOf(JsonNodeType.class);
    value.forEach(each -> types.add(each.getNodeType()));
    return value.isArray() && types.size() == 1 && value.get(0).isValueNode();
  }

  private static String topic(ObjectReader pairs, String from) {
    String to = pairs.requiredText(from);
    boolean legal = RosNames.isTopic(from) && to.startsWith("/") && RosNames.isTopic(to);
    if (!to.isBlank() && !legal) {
      pairs.find(
          ProjectRules.MODELER_COMPONENT_NODE,
          "'" + from + "' cannot be remapped to '" + to + "'.",
          pairs.at(from));
    }
    return to;
  }

  private static String legal(ObjectReader json, String key, String value, String pattern) {
    if (!value.matches(pattern)) {
      json.find(
          ProjectRules.MODELER_COMPONENT_NODE,
          "'" + value + "' is not a legal " + key + " of a node.",
          json.at(key));
    }
    return value;
  }

  /** Returns the folder above the outermost Python package of a file. */
  private static Path root(Path file) {
    Path folder = file.getParent();
    while (Files.isRegularFile(folder.resolve("__init__.py"))) {
      folder = folder.getParent();
    }
    return folder;
  }
}
