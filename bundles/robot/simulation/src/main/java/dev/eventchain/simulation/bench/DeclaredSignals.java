package dev.eventchain.simulation.bench;

import dev.eventchain.messages.RosNames;
import dev.eventchain.model.Signal.Direction;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** What a project says of its topics in {@code signals.json}. */
final class DeclaredSignals {

  private final Map<String, dev.eventchain.model.Signal> topics = new LinkedHashMap<>();

  DeclaredSignals(List<dev.eventchain.model.Signal> signals) {
    signals.forEach(each -> topics.putIfAbsent(RosNames.resolve(each.topic(), ""), each));
  }

  /** Whether nothing is said of any topic, so that none is unknown either. */
  boolean isEmpty() {
    return topics.isEmpty();
  }

  /** The full names of the topics of a direction. */
  List<String> names(Direction direction) {
    List<String> names = new ArrayList<>();
    topics.forEach(
        (name, signal) -> {
          if (signal.direction() == direction) {
            names.add(name);
          }
        });
    return names;
  }

  /** What is said of the topic with a full name. */
  Optional<dev.eventchain.model.Signal> find(String topic) {
    return Optional.ofNullable(topics.get(topic));
  }

  /** All of them. */
  List<String> names() {
    return List.copyOf(topics.keySet());
  }

  /** The unit of a field, as it is written; empty if none is said. */
  Optional<String> unit(String topic, String field) {
    return find(topic)
        .flatMap(signal -> signal.field(field))
        .map(dev.eventchain.model.Signal.Field::unit)
        .filter(unit -> !unit.isEmpty());
  }
}
