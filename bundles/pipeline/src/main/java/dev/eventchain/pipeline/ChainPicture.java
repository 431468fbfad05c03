package dev.eventchain.pipeline;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.metamodel.TopicIndex;
import dev.eventchain.metamodel.eventchain.EventChain;
import dev.eventchain.metamodel.eventchain.SoftwareNode;
import java.util.List;

/** A chain as nodes and edges; an edge without a node at one end leads out of the chain. */
final class ChainPicture {

  private ChainPicture() {}

  static ObjectNode of(EventChain chain) {
    ObjectNode picture = JsonNodeFactory.instance.objectNode();
    picture.put("name", chain.getName());
    ArrayNode nodes = picture.putArray("nodes");
    chain.getSoftware().forEach(node -> nodes.add(node(node)));
    ArrayNode edges = picture.putArray("edges");
    for (TopicIndex.Topic topic : TopicIndex.of(chain).topics()) {
      for (String from : names(topic.publishers())) {
        for (String to : names(topic.subscribers())) {
          edges.addObject().put("from", from).put("to", to).put("topic", topic.name());
        }
      }
    }
    return picture;
  }

  private static List<String> names(List<TopicIndex.Endpoint> endpoints) {
    return endpoints.isEmpty()
        ? List.of("")
        : endpoints.stream().map(endpoint -> text(endpoint.node().getName())).toList();
  }

  private static ObjectNode node(SoftwareNode node) {
    ObjectNode result = JsonNodeFactory.instance.objectNode();
    result.put("name", text(node.getName()));
    if (node.isSetFrequency()) {
      result.put("frequency", node.getFrequency());
    }
    result.put("origin", node.getOrigin().getName());
    return result;
  }

  private static String text(String value) {
    return value == null ? "" : value;
  }
}
