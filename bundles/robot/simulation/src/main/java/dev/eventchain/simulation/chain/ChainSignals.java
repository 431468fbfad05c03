package dev.eventchain.simulation.chain;

import dev.eventchain.messages.FieldType;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.Unit;
import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.bench.BenchSignals;
import dev.eventchain.simulation.bench.TypedTopic;
import dev.eventchain.simulation.formula.NamedValues;
import dev.eventchain.simulation.formula.Signal;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * Signals between the components of a chain, for reports: the fields of topics that hold only
 * single numbers and Booleans. Topics that drive the vehicle are left out, since their quantities
 * belong to the world, and so are sensor topics, which are too large.
 */
public final class ChainSignals {

  private final Map<TypedTopic, List<Signal>> signals = new LinkedHashMap<>();

  private ChainSignals() {}

  /** Returns the signals of the topics that components write. */
  static ChainSignals of(Collection<TopicIndex.Topic> topics, MessageCatalog catalog, Bench bench) {
    ChainSignals chain = new ChainSignals();
    for (TopicIndex.Topic topic : topics) {
      List<Data> written =
          topic.publishers().stream().flatMap(each -> each.data().stream()).toList();
      type(written, catalog).ifPresent(type -> chain.add(topic.name(), type, written, bench));
    }
    return chain;
  }

  private static Optional<MessageType> type(List<Data> written, MessageCatalog catalog) {
    return written.isEmpty()
        ? Optional.empty()
        : Optional.ofNullable(written.get(0).getMessageType()).flatMap(catalog::find);
  }

  private void add(String topic, MessageType type, List<Data> written, Bench bench) {
    Map<String, Signal> found = new TreeMap<>();
    for (Data data : written) {
      Optional<FieldType> field =
          Optional.ofNullable(data.getFieldName()).flatMap(path -> type.resolve(path).type());
      if (field.filter(BenchSignals::isNumberOrTruth).isEmpty()) {
        return;
      }
      if (!drives(bench.consumed().get(topic), data.getFieldName())) {
        boolean truth = field.get().kind() == FieldType.Kind.BOOL;
        Signal signal = signal(topic, data, type.name(), truth);
        NamedValues names = bench.signals().named(topic, type.name(), data.getFieldName());
        found.put(signal.name(), names.isText() ? signal : signal.withNames(names));
      }
    }
    signals.put(new TypedTopic(topic, type.name()), List.copyOf(found.values()));
  }

  private static boolean drives(Bench.Consumed consumed, String path) {
    return consumed != null
        && consumed.fields().stream()
            .anyMatch(each -> each.path().equals(path) && each.actuator().isPresent());
  }

  private static Signal signal(String topic, Data data, String type, boolean truth) {
    boolean known = data.getUnit() != null && Unit.parse(data.getUnit()).isPresent();
    return BenchSignals.ofField(
        topic, data.getFieldName(), type, known ? data.getUnit() : "1", truth);
  }

  /** Returns the topics with such signals. */
  public List<TypedTopic> topics() {
    return signals.keySet().stream().filter(topic -> !signals.get(topic).isEmpty()).toList();
  }

  /** Returns the signals of a topic. */
  public List<Signal> on(String topic) {
    return signals.entrySet().stream()
        .filter(each -> each.getKey().name().equals(topic))
        .flatMap(each -> each.getValue().stream())
        .toList();
  }

  /** Returns these and other signals by name, without duplicates. */
  public List<Signal> with(List<Signal> others) {
    Map<String, Signal> all = new TreeMap<>();
    signals.values().forEach(each -> each.forEach(signal -> all.put(signal.name(), signal)));
    others.forEach(signal -> all.put(signal.name(), signal));
    return new ArrayList<>(all.values());
  }
}
