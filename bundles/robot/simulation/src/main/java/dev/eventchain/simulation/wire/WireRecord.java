package dev.eventchain.simulation.wire;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Merges the logs of all nodes and the world in one scenario. Nodes identify samples by source
 * timestamps; the merged log numbers them by topic, in the order of their publication.
 */
final class WireRecord {

  private static final Comparator<long[]> BY_TIME =
      Comparator.<long[]>comparingLong(sample -> sample[1]).thenComparingLong(sample -> sample[0]);

  /** Source timestamp and publication time of each sample. */
  private final Map<String, List<long[]>> samples = new TreeMap<>();

  private final Map<String, Map<Long, Integer>> numbers = new HashMap<>();
  private final List<JsonNode> nodes = new ArrayList<>();

  /** Adds the publications of the world: source timestamps and times, by topic. */
  void add(Map<String, Map<Long, Long>> publications) {
    publications.forEach((topic, times) -> times.forEach((stamp, it) -> add(topic, stamp, it)));
  }

  /**
   * Adds the content of a node's FINISHED frame.
   *
   * @throws IllegalArgumentException if it violates the protocol
   */
  void add(JsonNode finished) {
    finished
        .required("publications")
        .properties()
        .forEach(
            topic ->
                topic.getValue().forEach(it -> add(topic.getKey(), number(it, 0), number(it, 1))));
    finished.required("nodes").forEach(nodes::add);
  }

  private void add(String topic, long stamp, long time) {
    samples.computeIfAbsent(topic, it -> new ArrayList<>()).add(new long[] {stamp, time});
  }

  /**
   * Returns the log in the format of the lock-step host.
   *
   * @throws IllegalArgumentException if two samples have one timestamp, or a read sample was never
   *     written
   */
  ObjectNode toJson() {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    ObjectNode publications = JsonNodeFactory.instance.objectNode();
    samples.forEach((topic, list) -> publications.set(topic, numbered(topic, list)));
    ArrayNode all = json.putArray("nodes");
    nodes.forEach(node -> all.add(translated(node)));
    json.set("publications", publications);
    return json;
  }

  private ArrayNode numbered(String topic, List<long[]> list) {
    list.sort(BY_TIME);
    Map<Long, Integer> known = numbers.computeIfAbsent(topic, it -> new HashMap<>());
    ArrayNode json = JsonNodeFactory.instance.arrayNode();
    for (long[] sample : list) {
      json.addArray().add(known.size()).add(sample[1]);
      if (known.put(sample[0], known.size()) != null) {
        throw new IllegalArgumentException("two samples of " + topic + " with one name");
      }
    }
    return json;
  }

  private ObjectNode translated(JsonNode node) {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    json.set("name", node.required("name"));
    for (String ofFault : List.of("affected", "affected_first", "loss")) {
      if (node.has(ofFault)) {
        json.set(ofFault, node.get(ofFault));
      }
    }
    ArrayNode activations = json.putArray("activations");
    for (JsonNode activation : node.required("activations")) {
      ArrayNode translated = activations.addArray();
      for (int i = 0; i < 3; i++) {
        translated.add(number(activation, i));
      }
      translated.add(translatedSamples(activation.required(3)));
      translated.add(translatedSamples(activation.required(4)));
    }
    return json;
  }

  private ArrayNode translatedSamples(JsonNode list) {
    ArrayNode json = JsonNodeFactory.instance.arrayNode();
    for (JsonNode sample : list) {
      String topic = sample.required(0).asText();
      Integer number = numbers.getOrDefault(topic, Map.of()).get(number(sample, 1));
      if (number == null) {
        throw new IllegalArgumentException("a sample of " + topic + " that nobody wrote");
      }
      json.addArray().add(topic).add(number);
    }
    return json;
  }

  private static long number(JsonNode array, int index) {
    JsonNode number = array.required(index);
    if (!number.isIntegralNumber() || !number.canConvertToLong()) {
      throw new IllegalArgumentException("something that is not a whole number");
    }
    return number.longValue();
  }
}
