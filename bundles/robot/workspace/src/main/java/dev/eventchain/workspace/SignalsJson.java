package dev.eventchain.workspace;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.description.ChainNames;
import dev.eventchain.documents.JsonLayout;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;

/** The text of {@code signals.json} for nodes: their topics, with the fields that they use. */
final class SignalsJson {

  private SignalsJson() {}

  /**
   * Returns the text. A topic that no component writes is provided by the vehicle, one that none
   * reads is consumed by it.
   *
   * @param nodes also those that are no components
   */
  static String of(List<DescribedNode> nodes, List<DescribedNode> components) {
    SortedMap<String, List<DescribedEndpoint>> topics = new TreeMap<>();
    List<DescribedEndpoint> all =
        nodes.stream().flatMap(node -> node.endpoints().stream()).toList();
    all.forEach(
        endpoint ->
            topics.put(
                endpoint.topic(),
                all.stream().filter(it -> it.topic().equals(endpoint.topic())).toList()));
    ArrayNode json = JsonNodeFactory.instance.arrayNode();
    List<DescribedEndpoint> own =
        components.stream().flatMap(node -> node.endpoints().stream()).toList();
    topics.forEach((topic, endpoints) -> json.add(signal(topic, endpoints, own)));
    return JsonLayout.of(json) + "\n";
  }

  private static ObjectNode signal(
      String topic, List<DescribedEndpoint> endpoints, List<DescribedEndpoint> own) {
    DescribedEndpoint first = endpoints.get(0);
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    json.put("Topic Name", topic).put("Message Type", first.type());
    endpoints.stream()
        .flatMap(endpoint -> endpoint.qos().stream())
        .findFirst()
        .ifPresent(qos -> json.set(ChainNames.QOS_PROFILE, DescribedEndpoint.qos(qos)));
    json.put("direction", direction(endpoints.stream().filter(own::contains).toList()));
    ArrayNode fields = json.putArray("Message Definition");
    Set<MessageFields.Leaf> used = new LinkedHashSet<>();
    endpoints.stream()
        .filter(endpoint -> endpoint.type().equals(first.type()))
        .forEach(endpoint -> used.addAll(endpoint.fields()));
    for (MessageFields.Leaf field : used) {
      ObjectNode entry = fields.addObject().put("Field", field.path());
      entry.put("Type", field.type().toString());
      field.unit().ifPresent(unit -> entry.put("Unit", unit));
    }
    return json;
  }

  private static String direction(List<DescribedEndpoint> endpoints) {
    boolean written = endpoints.stream().anyMatch(DescribedEndpoint::isOutput);
    boolean read = endpoints.stream().anyMatch(endpoint -> !endpoint.isOutput());
    return !written && !read ? "internal" : !written ? "provided" : read ? "internal" : "consumed";
  }
}
