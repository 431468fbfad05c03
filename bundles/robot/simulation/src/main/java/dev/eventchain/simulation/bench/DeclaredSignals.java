package dev.eventchain.simulation.bench;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.messages.QosSettings;
import dev.eventchain.messages.RosNames;
import dev.eventchain.model.Signal.Direction;
import dev.eventchain.model.Signal.Values;
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

  /** Reports texts and constants of a field that it never has, as its signal is declared. */
  void check(ObjectReader part, String topic, String path, Bench.Source found) {
    List<?> sent =
        found instanceof ChosenText chosen
            ? chosen.texts()
            : found instanceof Bench.Constant constant ? List.of(constant.value()) : List.of();
    Values values =
        find(topic)
            .flatMap(signal -> signal.field(path))
            .map(dev.eventchain.model.Signal.Field::values)
            .orElse(Values.ANY);
    for (Object value : sent) {
      if (!values.hold(value)) {
        String message = "'%s' of %s is never '%s'.".formatted(path, topic, value);
        String hint =
            value instanceof String text
                ? NearestName.hint(text, values.texts())
                : "Its signal has a range, outside of which no vehicle sends it.";
        part.find(
            Diagnostic.of(BenchRules.BENCH_VALUE_RANGE, message, part.at(path)).withHint(hint));
      }
    }
  }

  /** Returns the fields of a topic that have certain values only. */
  List<dev.eventchain.model.Signal.Field> limited(String topic) {
    return find(topic).stream()
        .flatMap(signal -> signal.fields().stream())
        .filter(field -> field.values().isLimited())
        .toList();
  }

  /** Returns the unit of a field, as written; empty if none is declared. */
  Optional<String> unit(String topic, String field) {
    return find(topic)
        .flatMap(signal -> signal.field(field))
        .map(dev.eventchain.model.Signal.Field::unit)
        .filter(unit -> !unit.isEmpty());
  }
}
