package dev.eventchain.simulation.bench;

import dev.eventchain.messages.QosSettings;
import dev.eventchain.messages.RosNames;
import dev.eventchain.model.Signal.Direction;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Topics that a project declares in {@code signals.json}. */
final class DeclaredSignals {

  private final Map<String, dev.eventchain.model.Signal> topics = new LinkedHashMap<>();

  DeclaredSignals(List<dev.eventchain.model.Signal> signals) {
    signals.forEach(each -> topics.putIfAbsent(RosNames.resolve(each.topic(), ""), each));
  }

  /** Returns whether no topic is declared, so that none counts as unknown. */
  boolean isEmpty() {
    return topics.isEmpty();
  }

  /** Returns the full names of the topics of a direction. */
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

  /** Returns the declared signal of a topic, by its full name. */
  Optional<dev.eventchain.model.Signal> find(String topic) {
    return Optional.ofNullable(topics.get(topic));
  }

  /** Returns the QoS of the vehicle on a topic; the default of ROS 2 if none is declared. */
  QosSettings quality(String topic) {
    return find(topic).map(dev.eventchain.model.Signal::quality).orElseGet(QosSettings::defaults);
  }

  /** Returns the full names of all topics. */
  List<String> names() {
    return List.copyOf(topics.keySet());
  }

  /** Returns the unit of a field, as written; empty if none is declared. */
  Optional<String> unit(String topic, String field) {
    return find(topic)
        .flatMap(signal -> signal.field(field))
        .map(dev.eventchain.model.Signal.Field::unit)
        .filter(unit -> !unit.isEmpty());
  }
}
