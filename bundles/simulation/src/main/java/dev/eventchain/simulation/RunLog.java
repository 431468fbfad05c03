package dev.eventchain.simulation;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** What the nodes did in a scenario: each activation with the samples that it read and wrote. */
record RunLog(Map<String, List<Activation>> nodes, Map<String, Map<Long, Long>> publications) {

  /** The sample with this sequence number on a topic. */
  record SampleId(String topic, long sequence) {}

  /** One execution of a node; times in ns, simulated except {@code host}. */
  record Activation(long start, long end, long host, List<SampleId> reads, List<SampleId> writes) {}

  /**
   * From the content of a FINISHED frame.
   *
   * @throws IllegalArgumentException if it is not as the protocol says
   */
  static RunLog parse(JsonNode json) {
    Map<String, List<Activation>> nodes = new LinkedHashMap<>();
    for (JsonNode node : json.required("nodes")) {
      List<Activation> activations = new ArrayList<>();
      for (JsonNode activation : node.required("activations")) {
        activations.add(
            new Activation(
                number(activation, 0),
                number(activation, 1),
                number(activation, 2),
                samples(activation.required(3)),
                samples(activation.required(4))));
      }
      if (nodes.put(text(node.required("name")), activations) != null) {
        throw new IllegalArgumentException("a node twice");
      }
    }
    Map<String, Map<Long, Long>> publications = new LinkedHashMap<>();
    json.required("publications")
        .properties()
        .forEach(topic -> publications.put(topic.getKey(), times(topic.getValue())));
    return new RunLog(nodes, publications);
  }

  private static long number(JsonNode array, int index) {
    JsonNode number = array.required(index);
    if (!number.isIntegralNumber() || !number.canConvertToLong()) {
      throw new IllegalArgumentException("something that is no whole number");
    }
    return number.longValue();
  }

  private static String text(JsonNode json) {
    if (!json.isTextual()) {
      throw new IllegalArgumentException("something that is no text");
    }
    return json.textValue();
  }

  private static List<SampleId> samples(JsonNode json) {
    List<SampleId> samples = new ArrayList<>(json.size());
    for (JsonNode sample : json) {
      samples.add(new SampleId(text(sample.required(0)), number(sample, 1)));
    }
    return samples;
  }

  private static Map<Long, Long> times(JsonNode json) {
    Map<Long, Long> times = new LinkedHashMap<>();
    for (JsonNode publication : json) {
      times.put(number(publication, 0), number(publication, 1));
    }
    return times;
  }

  /**
   * When the samples of a topic could be seen, in ns, by their numbers; empty if there are none.
   */
  Map<Long, Long> publicationsOf(String topic) {
    return publications.getOrDefault(topic, Map.of());
  }

  /** When a sample could be seen, in ns. */
  long time(SampleId sample) {
    return publications.get(sample.topic()).get(sample.sequence());
  }
}
