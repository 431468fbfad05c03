package dev.eventchain.analysis;

import dev.eventchain.metamodel.Signal;
import dev.eventchain.metamodel.eventchain.Data;
import dev.eventchain.metamodel.eventchain.EventChain;
import dev.eventchain.metamodel.eventchain.SoftwareNode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * A topic and everyone on it, in chain order.
 *
 * @param signal what is known of the topic outside of the chain
 */
record Topic(
    String name, List<Endpoint> publishers, List<Endpoint> subscribers, Optional<Signal> signal) {

  /** The topics of a chain, in the order in which they appear. Data without a topic have none. */
  static List<Topic> of(EventChain chain, Map<String, Signal> signals) {
    Map<String, Topic> topics = new LinkedHashMap<>();
    for (SoftwareNode node : chain.getSoftware()) {
      byTopic(node.getInput())
          .forEach(
              (name, data) ->
                  topic(topics, name, signals).subscribers.add(new Endpoint(node, data)));
      byTopic(node.getOutput())
          .forEach(
              (name, data) ->
                  topic(topics, name, signals).publishers.add(new Endpoint(node, data)));
    }
    return List.copyOf(topics.values());
  }

  private static Map<String, List<Data>> byTopic(List<Data> all) {
    Map<String, List<Data>> groups = new LinkedHashMap<>();
    for (Data data : all) {
      if (data.getTopicName() != null && !data.getTopicName().isEmpty()) {
        groups.computeIfAbsent(data.getTopicName(), key -> new ArrayList<>()).add(data);
      }
    }
    return groups;
  }

  private static Topic topic(Map<String, Topic> topics, String name, Map<String, Signal> signals) {
    return topics.computeIfAbsent(
        name,
        key ->
            new Topic(
                key, new ArrayList<>(), new ArrayList<>(), Optional.ofNullable(signals.get(key))));
  }

  /** The publishers, then the subscribers. */
  List<Endpoint> endpoints() {
    return Stream.concat(publishers.stream(), subscribers.stream()).toList();
  }

  boolean is(Signal.Direction direction) {
    return signal.map(known -> known.direction() == direction).orElse(false);
  }
}
