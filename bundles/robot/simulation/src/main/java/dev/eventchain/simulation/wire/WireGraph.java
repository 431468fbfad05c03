package dev.eventchain.simulation.wire;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.messages.QosSettings;
import dev.eventchain.messages.QosSettings.History;
import dev.eventchain.messages.QosSettings.Incompatibility;
import dev.eventchain.messages.QosSettings.Reliability;
import dev.eventchain.simulation.host.HostRules;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.stream.Collectors;

/**
 * All writers and readers of a scenario, and their matches: the connections before it starts, and
 * the number of samples that must arrive.
 *
 * @param writers of the nodes in their order, then of the world
 * @param readers likewise
 */
record WireGraph(List<WireEnd> writers, List<WireEnd> readers) {

  /** QoS of a writer of the world that states none: the default of ROS 2. */
  private static final QosSettings OFFER = QosSettings.defaults().withHistory(History.KEEP_ALL);

  WireGraph {
    writers = List.copyOf(writers);
    readers = List.copyOf(readers);
  }

  /**
   * Returns the graph of nodes and the world, which offers and requests the QoS of the
   * configuration. Topics that it states none for are only observed, whatever is offered.
   *
   * @param ready the descriptions from the hosts, in the order of the nodes
   * @param configuration names the topics of the world
   * @throws IllegalArgumentException if a host violates the protocol
   */
  static WireGraph of(List<JsonNode> ready, JsonNode configuration) {
    List<WireEnd> writers = new ArrayList<>();
    List<WireEnd> readers = new ArrayList<>();
    for (int node = 0; node < ready.size(); node++) {
      ends(node, ready.get(node).required("writers"), writers);
      ends(node, ready.get(node).required("readers"), readers);
    }
    return around(writers, readers, configuration);
  }

  /**
   * Returns the graph of known writers and readers and the world.
   *
   * @param offered the writers of the nodes
   * @param requested the readers of the nodes
   */
  static WireGraph around(List<WireEnd> offered, List<WireEnd> requested, JsonNode configuration) {
    List<WireEnd> writers = new ArrayList<>(offered);
    List<WireEnd> readers = new ArrayList<>(requested);
    int index = 0;
    for (JsonNode topic : configuration.path("world_publishes")) {
      writers.add(world(index++, topic, OFFER));
    }
    index = 0;
    for (JsonNode topic : configuration.path("world_subscribes")) {
      readers.add(world(index++, topic, observation(topic.path("topic").asText(), offered)));
    }
    return new WireGraph(writers, readers);
  }

  private static void ends(int node, JsonNode described, List<WireEnd> ends) {
    for (int index = 0; index < described.size(); index++) {
      ends.add(WireEnd.of(node, index, described.get(index)));
    }
  }

  private static WireEnd world(int index, JsonNode topic, QosSettings unstated) {
    JsonNode stated = topic.path("qos");
    return new WireEnd(
        WireEnd.WORLD,
        index,
        topic.path("topic").asText(),
        topic.path("type").asText(),
        stated.isMissingNode() ? unstated : WireEnd.quality(stated),
        "");
  }

  /** Returns the QoS of a reader that observes a topic, which requests what all writers offer. */
  private static QosSettings observation(String topic, List<WireEnd> offered) {
    return OFFER.withReliability(
        offered.stream()
            .filter(end -> end.topic().equals(topic))
            .map(end -> end.qos().reliability())
            .min(Comparator.naturalOrder())
            .orElse(Reliability.BEST_EFFORT));
  }

  /** Returns the writers that match a reader. */
  List<WireEnd> sources(WireEnd reader) {
    return writers.stream().filter(writer -> writer.feeds(reader)).toList();
  }

  /** Returns the readers that match a writer. */
  List<WireEnd> sinks(WireEnd writer) {
    return readers.stream().filter(writer::feeds).toList();
  }

  /** Returns the writers of an owner. */
  List<WireEnd> writersOf(int owner) {
    return writers.stream().filter(end -> end.owner() == owner).toList();
  }

  /** Returns the readers of an owner. */
  List<WireEnd> readersOf(int owner) {
    return readers.stream().filter(end -> end.owner() == owner).toList();
  }

  /** Returns the index of this writer's owner among those that write on the topic. */
  int turn(WireEnd writer) {
    return owners(writer.topic()).indexOf(writer.owner());
  }

  /** Returns the owners that write on a topic, the world first. */
  List<Integer> owners(String topic) {
    return writers.stream()
        .filter(end -> end.topic().equals(topic))
        .map(WireEnd::owner)
        .distinct()
        .sorted()
        .toList();
  }

  /**
   * Returns the content of the CONNECT frame for a node.
   *
   * @param guid returns the GUID of an end
   */
  ObjectNode connect(int node, Duration timeout, Function<WireEnd, String> guid) {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    ArrayNode sinks = json.putArray("writers");
    ArrayNode turns = json.putArray("turns");
    for (WireEnd writer : writersOf(node)) {
      ArrayNode of = sinks.addArray();
      sinks(writer).forEach(reader -> of.add(guid.apply(reader)));
      turns.addArray().add(turn(writer)).add(owners(writer.topic()).size());
    }
    ArrayNode sources = json.putArray("readers");
    for (WireEnd reader : readersOf(node)) {
      ArrayNode of = sources.addArray();
      sources(reader).forEach(writer -> of.add(guid.apply(writer)));
    }
    json.put("timeout_s", timeout.toMillis() / 1e3);
    return json;
  }

  /** Returns the missing connections, with the ids and messages of lock-step. */
  ArrayNode warnings() {
    ArrayNode warnings = JsonNodeFactory.instance.arrayNode();
    for (WireEnd reader : readers) {
      for (WireEnd writer : writers) {
        if (writer.owner() != reader.owner() && writer.topic().equals(reader.topic())) {
          warn(writer, reader, warnings);
        }
      }
    }
    return warnings;
  }

  private static void warn(WireEnd writer, WireEnd reader, ArrayNode warnings) {
    String topic = reader.topic();
    if (!writer.type().equals(reader.type())) {
      String types = reader.type() + " is subscribed and " + writer.type() + " published";
      add(
          HostRules.TOPIC_TYPE_MISMATCH,
          topic,
          "On topic '" + topic + "', " + types + ". No messages will be received.",
          warnings);
      return;
    }
    List<Incompatibility> found = QosSettings.incompatibilities(writer.qos(), reader.qos());
    if (!found.isEmpty()) {
      String policies =
          found.stream()
              .map(each -> each.policy().equals("lease duration") ? "liveliness" : each.policy())
              .map(policy -> policy.toUpperCase(Locale.ROOT))
              .distinct()
              .collect(Collectors.joining(", "));
      add(
          HostRules.QOS_INCOMPATIBLE,
          topic,
          "New publisher discovered on topic '"
              + topic
              + "', offering incompatible QoS. No messages"
              + " will be received from it. Last incompatible policy: "
              + policies,
          warnings);
    }
  }

  private static void add(Rule rule, String topic, String message, ArrayNode warnings) {
    warnings.addObject().put("id", rule.id()).put("topic", topic).put("message", message);
  }
}
