package dev.eventchain.simulation.host;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Log of the nodes in a scenario: each activation with the samples that it read and wrote.
 *
 * @param answers of the components' outputs to pulses of their inputs, where they were asked for
 */
public record RunLog(
    Map<String, List<Activation>> nodes,
    Map<String, Map<Long, Long>> publications,
    Map<String, Affected> affected,
    Map<String, List<Answer>> answers) {

  /** A time, in ns, that no scenario reaches. */
  public static final long NEVER = 1L << 62;

  /** Creates the log of a run without a fault. */
  public RunLog(Map<String, List<Activation>> nodes, Map<String, Map<Long, Long>> publications) {
    this(nodes, publications, Map.of(), Map.of());
  }

  /**
   * Effect of a fault on a node.
   *
   * @param count number of altered activations or messages
   * @param first time of the first of them, in ns
   * @param loss why the node was lost, as the process reported it; missing if it was not
   */
  public record Affected(long count, long first, JsonNode loss) {}

  /**
   * An answer of a component's output to a pulse of an input, in a replay of its calls.
   *
   * @param moment the time of the pulse, in ns
   * @param delay the time from there to the first call whose output differs, in ns
   */
  public record Answer(String input, String output, long moment, long delay) {}

  /** The sample with this sequence number on a topic. */
  public record SampleId(String topic, long sequence) {}

  /** One execution of a node; times in ns, simulated except {@code host}. */
  public record Activation(
      long start, long end, long host, List<SampleId> reads, List<SampleId> writes) {}

  /**
   * Parses the content of a FINISHED frame.
   *
   * @throws IllegalArgumentException if it violates the protocol
   */
  public static RunLog parse(JsonNode json) {
    Map<String, List<Activation>> nodes = new LinkedHashMap<>();
    Map<String, Affected> affected = new LinkedHashMap<>();
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
      if (node.has("affected")) {
        affected.put(text(node.required("name")), affected(node));
      }
    }
    Map<String, Map<Long, Long>> publications = new LinkedHashMap<>();
    json.required("publications")
        .properties()
        .forEach(topic -> publications.put(topic.getKey(), times(topic.getValue())));
    return new RunLog(nodes, publications, affected, answers(json.path("answers")));
  }

  private static Map<String, List<Answer>> answers(JsonNode json) {
    Map<String, List<Answer>> answers = new LinkedHashMap<>();
    json.properties().forEach(node -> answers.put(node.getKey(), answersOfNode(node.getValue())));
    return answers;
  }

  private static List<Answer> answersOfNode(JsonNode json) {
    List<Answer> answers = new ArrayList<>(json.size());
    for (JsonNode answer : json) {
      String input = text(answer.required(0));
      String output = text(answer.required(1));
      answers.add(new Answer(input, output, number(answer, 2), number(answer, 3)));
    }
    return answers;
  }

  private static Affected affected(JsonNode node) {
    long count = node.path("affected").longValue();
    return new Affected(count, node.path("affected_first").longValue(), node.path("loss"));
  }

  private static long number(JsonNode array, int index) {
    JsonNode number = array.required(index);
    if (!number.isIntegralNumber() || !number.canConvertToLong()) {
      throw new IllegalArgumentException("something that is not a whole number");
    }
    return number.longValue();
  }

  private static String text(JsonNode json) {
    if (!json.isTextual()) {
      throw new IllegalArgumentException("something that is not a string");
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
   * Returns the publication times of a topic's samples, in ns, by sequence number; may be empty.
   */
  public Map<Long, Long> publicationsOf(String topic) {
    return publications.getOrDefault(topic, Map.of());
  }

  /** Returns the publication time of a sample, in ns. */
  public long time(SampleId sample) {
    return publications.get(sample.topic()).get(sample.sequence());
  }
}
