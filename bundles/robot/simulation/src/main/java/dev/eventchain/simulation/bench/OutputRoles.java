package dev.eventchain.simulation.bench;

import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.Unit;
import dev.eventchain.model.TopicIndex;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.model.eventchain.Requirement;
import dev.eventchain.model.eventchain.SoftwareNode;
import dev.eventchain.simulation.bench.BenchSignals.Topic;
import dev.eventchain.simulation.formula.Signal;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;

/**
 * The outputs of a chain by the requirements that they satisfy, so that a formula can read an
 * output whatever topic a design has chosen for it. Only single numbers and Booleans count, and no
 * time stamps; where there is none of them, texts of which a catalogue knows all count.
 */
final class OutputRoles {

  private final EventChain chain;
  private final MessageCatalog catalog;
  private final FieldNames names;
  private final Map<String, Topic> topics = new LinkedHashMap<>();

  OutputRoles(EventChain chain, MessageCatalog catalog, FieldNames names) {
    this.chain = chain;
    this.catalog = catalog;
    this.names = names;
    for (SoftwareNode node : chain.getSoftware()) {
      node.getOutput().forEach(data -> add(node, data));
    }
  }

  private void add(SoftwareNode node, Data data) {
    Optional<String> name = TopicIndex.nameOf(data, node);
    if (name.isPresent() && data.getMessageType() != null && data.getFieldName() != null) {
      Topic topic =
          topics.computeIfAbsent(
              name.get(), it -> new Topic(it, data.getMessageType(), new LinkedHashMap<>()));
      topic.units().putIfAbsent(data.getFieldName(), unit(data));
    }
  }

  private static String unit(Data data) {
    return data.getUnit() == null ? "" : data.getUnit();
  }

  /** Returns a topic that the chain writes, by its full name. */
  Optional<Topic> topic(String name) {
    return Optional.ofNullable(topics.get(name));
  }

  /**
   * Returns the outputs that are marked with a requirement; if none is, those of the components
   * that satisfy it.
   *
   * @param kind {@code bool} or a unit of the wanted dimension; empty for any output
   */
  List<Signal> find(String requirement, Optional<String> kind) {
    List<Signal> marked =
        outputs(data -> isIn(data.getSatisfies(), requirement), node -> true, kind);
    return marked.isEmpty()
        ? outputs(data -> true, node -> isIn(node.getSatisfies(), requirement), kind)
        : marked;
  }

  private static boolean isIn(Collection<Requirement> requirements, String id) {
    return requirements.stream().anyMatch(it -> id.equals(it.getId()));
  }

  private List<Signal> outputs(
      Predicate<Data> wanted, Predicate<SoftwareNode> by, Optional<String> kind) {
    Map<String, Signal> found = new LinkedHashMap<>();
    for (SoftwareNode node : chain.getSoftware()) {
      if (by.test(node)) {
        node.getOutput().stream()
            .filter(wanted)
            .flatMap(data -> signal(node, data).stream())
            .filter(signal -> isOf(kind, signal))
            .forEach(signal -> found.putIfAbsent(signal.name(), signal));
      }
    }
    List<Signal> all = new ArrayList<>(found.values());
    List<Signal> quantities = all.stream().filter(it -> !it.named().isText()).toList();
    return quantities.isEmpty() ? all : quantities;
  }

  private static boolean isOf(Optional<String> kind, Signal signal) {
    if (kind.isEmpty() || signal.truth()) {
      return kind.isEmpty() || kind.get().equals("bool");
    }
    if (signal.named().isText()) {
      return false;
    }
    return Unit.parse(kind.get()).filter(it -> areComparable(it, signal.dimension())).isPresent();
  }

  private static boolean areComparable(Unit one, Unit other) {
    Unit.Relation relation = one.relationTo(other);
    return relation == Unit.Relation.SAME || relation == Unit.Relation.CONVERTIBLE;
  }

  private Optional<Signal> signal(SoftwareNode node, Data data) {
    return TopicIndex.nameOf(data, node)
        .flatMap(this::topic)
        .filter(topic -> data.getFieldName() != null && !isStamp(data.getFieldName()))
        .flatMap(topic -> signal(topic, data.getFieldName()));
  }

  private Optional<Signal> signal(Topic topic, String path) {
    return catalog
        .find(topic.type())
        .flatMap(type -> type.resolve(path).type())
        .flatMap(field -> BenchSignals.readable(topic, path, field, names));
  }

  private static boolean isStamp(String path) {
    return path.matches("(.*\\.)?(header|stamp)\\..*");
  }
}
