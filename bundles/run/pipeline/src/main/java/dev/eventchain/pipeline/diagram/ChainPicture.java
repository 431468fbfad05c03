package dev.eventchain.pipeline.diagram;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.SoftwareNode;
import java.util.List;

/**
 * A chain as nodes and edges; an edge with one node leads out of the chain, and is marked if the
 * model declares that.
 */
public final class ChainPicture {

  private ChainPicture() {}

  public static ObjectNode of(EventChain chain) {
    ObjectNode picture = JsonNodeFactory.instance.objectNode();
    picture.put("name", chain.getName());
    ArrayNode nodes = picture.putArray("nodes");
    chain.getSoftware().forEach(node -> nodes.add(node(node)));
    ArrayNode edges = picture.putArray("edges");
    for (TopicIndex.Topic topic : TopicIndex.of(chain).topics()) {
      boolean external = isExternal(topic);
      for (String from : names(topic.publishers())) {
        if (external) {
          edge(edges, from, "", topic).put("external", true);
        }
        for (String to : names(topic.subscribers())) {
          if (!external || !to.isEmpty()) {
            edge(edges, from, to, topic);
          }
        }
      }
    }
    return picture;
  }

  private static boolean isExternal(TopicIndex.Topic topic) {
    return topic.publishers().stream()
        .flatMap(publisher -> publisher.data().stream())
        .anyMatch(Data::isExternal);
  }

  private static ObjectNode edge(ArrayNode edges, String from, String to, TopicIndex.Topic topic) {
    return edges.addObject().put("from", from).put("to", to).put("topic", topic.name());
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
