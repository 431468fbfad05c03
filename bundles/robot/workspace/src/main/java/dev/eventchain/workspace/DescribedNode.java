package dev.eventchain.workspace;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.description.ChainNames;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;

/** A node as a component of {@code components.json}. */
record DescribedNode(String component, FoundNode node, List<DescribedEndpoint> endpoints) {

  /**
   * Returns the description.
   *
   * @param hosted its class, if it can be hosted as it is
   */
  ObjectNode json(Optional<PythonNode> hosted) {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    String place =
        String.format(Locale.ROOT, "The node %s, %s:%d", node.name(), node.file(), node.line());
    String said = node.description().isBlank() ? "" : node.description() + " ";
    json.put(ChainNames.NAME, component).put(ChainNames.DESCRIPTION, said + place + ".");
    json.put(ChainNames.IMPLEMENTATION, "node");
    hosted.ifPresent(python -> hosted(python, json));
    node.frequency().ifPresent(hertz -> json.put(ChainNames.FREQUENCY, hertz));
    json.putArray(ChainNames.REQUIREMENTS);
    Set<String> names = new HashSet<>();
    ports(json.putArray(ChainNames.INPUT), false, names);
    ports(json.putArray(ChainNames.OUTPUT), true, names);
    return json;
  }

  private static void hosted(PythonNode python, ObjectNode json) {
    json.put(ChainNames.FILE, SoftwareBaseFiles.NODES + python.file());
    ObjectNode launch = json.putObject(ChainNames.NODE).put("class", python.className());
    if (!python.name().isEmpty()) {
      launch.put("name", python.name());
    }
    if (!python.namespace().isEmpty()) {
      launch.put("namespace", python.namespace());
    }
    if (!python.remappings().isEmpty()) {
      ObjectNode remappings = launch.putObject("remappings");
      python.remappings().forEach(remappings::put);
    }
    python.arguments().ifPresent(given -> launch.set("arguments", given));
    if (!python.parameters().isEmpty()) {
      launch.putObject("parameters").setAll(python.parameters());
    }
  }

  private void ports(ArrayNode ports, boolean outputs, Set<String> names) {
    for (DescribedEndpoint endpoint : endpoints) {
      if (endpoint.isOutput() == outputs) {
        ObjectNode port = endpoint.port();
        ArrayNode values = port.putArray(ChainNames.VALUES);
        for (MessageFields.Leaf field : endpoint.fields()) {
          ObjectNode value = values.addObject();
          value.put(ChainNames.NAME, name(endpoint.topic(), field.path(), names));
          value.put(ChainNames.FIELD, field.path()).put(ChainNames.TYPE, field.type().toString());
          field.unit().ifPresent(unit -> value.put(ChainNames.UNIT, unit));
          value.put(ChainNames.DESCRIPTION, field.path() + " of " + endpoint.type());
        }
        ports.add(port);
      }
    }
  }

  /** Returns a name for a value: its path, behind its topic if another one has that. */
  private static String name(String topic, String path, Set<String> names) {
    String plain = path.replace('.', '_');
    String last = topic.substring(topic.lastIndexOf('/') + 1);
    String name = names.contains(plain) ? last + "_" + plain : plain;
    String unique = name.equals("self") ? "self_" : name;
    for (int i = 2; !names.add(unique); i++) {
      unique = name + "_" + i;
    }
    return unique;
  }
}
