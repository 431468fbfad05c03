package dev.eventchain.pipeline;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.metamodel.eventchain.Data;
import dev.eventchain.metamodel.eventchain.EventChain;
import dev.eventchain.metamodel.eventchain.SoftwareNode;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;

/** A chain as nodes and edges; an edge without a node at one end leads out of the chain. */
final class ChainPicture {

  private ChainPicture() {}

  static ObjectNode of(EventChain chain) {
    ObjectNode picture = JsonNodeFactory.instance.objectNode();
    picture.put("name", chain.getName());
    ArrayNode nodes = picture.putArray("nodes");
    chain.getSoftware().forEach(node -> nodes.add(node(node)));
    ArrayNode edges = picture.putArray("edges");
    Map<String, Set<String>> writers = topics(chain, true);
    Map<String, Set<String>> readers = topics(chain, false);
    Set<String> topics = new LinkedHashSet<>(writers.keySet());
    topics.addAll(readers.keySet());
    for (String topic : topics) {
      for (String from : writers.getOrDefault(topic, Set.of(""))) {
        for (String to : readers.getOrDefault(topic, Set.of(""))) {
          edges.addObject().put("from", from).put("to", to).put("topic", topic);
        }
      }
    }
    return picture;
  }

  private static Map<String, Set<String>> topics(EventChain chain, boolean written) {
    Map<String, Set<String>> topics = new LinkedHashMap<>();
    for (SoftwareNode node : chain.getSoftware()) {
      for (Data data : written ? node.getOutput() : node.getInput()) {
        topics
            .computeIfAbsent(text(data.getTopicName()), topic -> new LinkedHashSet<>())
            .add(text(node.getName()));
      }
    }
    return topics;
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
