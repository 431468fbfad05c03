package dev.eventchain.simulation.wire;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.messages.QosSettings;
import dev.eventchain.messages.QosSettings.Durability;
import dev.eventchain.messages.QosSettings.History;
import dev.eventchain.messages.QosSettings.Incompatibility;
import dev.eventchain.messages.QosSettings.Liveliness;
import dev.eventchain.messages.QosSettings.Reliability;
import dev.eventchain.simulation.host.HostRules;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * All writers and readers of a scenario, and their matches: the connections before it starts, and
 * the number of samples that must arrive.
 *
 * @param writers of the nodes in their order, then of the world
 * @param readers likewise
 */
record WireGraph(List<WireEnd> writers, List<WireEnd> readers) {

  WireGraph {
    writers = List.copyOf(writers);
    readers = List.copyOf(readers);
  }

  /**
   * Returns the graph of nodes and a matching world, which offers what all readers of a topic
   * request and requests what all writers of a topic offer.
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
   * Returns the graph of known writers and readers and a matching world.
   *
   * @param offered the writers of the nodes
   * @param requested the readers of the nodes
   */
  static WireGraph around(List<WireEnd> offered, List<WireEnd> requested, JsonNode configuration) {
    List<WireEnd> writers = new ArrayList<>(offered);
    List<WireEnd> readers = new ArrayList<>(requested);
    int index = 0;
    for (JsonNode topic : configuration.path("world_publishes")) {
      writers.add(world(index++, topic, name -> offer(on(name, requested))));
    }
    index = 0;
    for (JsonNode topic : configuration.path("world_subscribes")) {
      readers.add(world(index++, topic, name -> request(on(name, offered))));
    }
    return new WireGraph(writers, readers);
  }

  private static void ends(int node, JsonNode described, List<WireEnd> ends) {
    for (int index = 0; index < described.size(); index++) {
      ends.add(WireEnd.of(node, index, described.get(index)));
    }
  }

  private interface Policies {
    QosSettings of(String topic);
  }

  private static WireEnd world(int index, JsonNode topic, Policies policies) {
    String name = topic.path("topic").asText();
    String type = topic.path("type").asText();
    return new WireEnd(WireEnd.WORLD, index, name, type, policies.of(name));
  }

  private static List<QosSettings> on(String topic, List<WireEnd> ends) {
    return ends.stream().filter(end -> end.topic().equals(topic)).map(WireEnd::qos).toList();
  }

  private static QosSettings offer(List<QosSettings> requested) {
    return new QosSettings(
        Reliability.RELIABLE,
        requested.stream()
            .map(QosSettings::durability)
            .max(Comparator.naturalOrder())
            .orElse(Durability.VOLATILE),
        History.KEEP_ALL,
        0,
        shortest(requested.stream().map(QosSettings::deadline)),
        requested.stream()
            .map(QosSettings::liveliness)
            .max(Comparator.naturalOrder())
            .orElse(Liveliness.AUTOMATIC),
        shortest(requested.stream().map(QosSettings::lease)));
  }

  private static Optional<Duration> shortest(Stream<Optional<Duration>> times) {
    return times.flatMap(Optional::stream).min(Comparator.naturalOrder());
  }

  private static QosSettings request(List<QosSettings> offered) {
    return QosSettings.defaults()
        .withHistory(History.KEEP_ALL)
        .withReliability(
            offered.stream()
                .map(QosSettings::reliability)
                .min(Comparator.naturalOrder())
                .orElse(Reliability.BEST_EFFORT));
  }

  /** Returns the writers that match a reader. */
  List<WireEnd> sources(WireEnd reader) {
    return writers.stream().filter(writer -> writer.feeds(reader)).toList();
  }

  /** Returns the number of readers that match a writer. */
  int sinks(WireEnd writer) {
    return (int) readers.stream().filter(writer::feeds).count();
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

  /** Returns the content of the CONNECT frame for a node. */
  ObjectNode connect(int node, Duration timeout) {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    ArrayNode counts = json.putArray("writers");
    ArrayNode turns = json.putArray("turns");
    for (WireEnd writer : writersOf(node)) {
      counts.add(sinks(writer));
      turns.addArray().add(turn(writer)).add(owners(writer.topic()).size());
    }
    ArrayNode sources = json.putArray("readers");
    readersOf(node).forEach(reader -> sources.add(sources(reader).size()));
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
