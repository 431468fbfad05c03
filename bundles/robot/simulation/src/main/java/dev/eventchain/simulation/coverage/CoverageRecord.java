package dev.eventchain.simulation.coverage;

import dev.eventchain.messages.FieldType;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.MessageValue;
import dev.eventchain.messages.RosNames;
import dev.eventchain.model.eventchain.Data;
import dev.eventchain.simulation.chain.SimulatedChain;
import dev.eventchain.simulation.coverage.SignalCoverage.Kind;
import dev.eventchain.simulation.formula.NamedValues;
import dev.eventchain.simulation.scenario.Scenario;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Records which values the signals of a chain have in a scenario: the fields that its nodes read
 * and write, and those of the elements of lists among them. Time stamps and headers are left out.
 */
public final class CoverageRecord {

  private static final String HEADER = "header.";
  private static final String TIME = "builtin_interfaces/msg/";

  private final SimulatedChain chain;
  private final Map<String, Map<String, Field>> topics = new LinkedHashMap<>();

  /**
   * A recorded field.
   *
   * @param elements what is recorded of its elements, by the name of their field; empty for numbers
   */
  private record Field(String unit, FieldRecord values, Map<String, FieldRecord> elements) {

    /** Adds a value, {@code path} of a message. */
    void add(MessageValue message, String path) {
      Object value = message.get(path);
      values.add(value);
      if (value instanceof Collection<?> list && !elements.isEmpty()) {
        for (Object each : list) {
          elements.forEach((name, record) -> record.add(((MessageValue) each).get(name)));
        }
      } else if (!elements.isEmpty()) {
        message.forEachNumber(path, elements.get("")::addElement);
      }
    }

    void add(Field other) {
      values.add(other.values);
      elements.forEach((name, record) -> record.add(other.elements.get(name)));
    }

    /** Returns what was recorded, of the elements after the whole. */
    Stream<SignalCoverage> coverage(String topic, String path, String writer) {
      Stream<SignalCoverage> own = coverage(values, topic, path, writer);
      Stream<SignalCoverage> inner =
          elements.entrySet().stream()
              .flatMap(
                  each -> {
                    String name = each.getKey().isEmpty() ? "" : "." + each.getKey();
                    return coverage(each.getValue(), topic, path + "[]" + name, writer);
                  });
      return Stream.concat(own, inner);
    }

    private Stream<SignalCoverage> coverage(
        FieldRecord record, String topic, String path, String writer) {
      String own = path.endsWith("[]") || !path.contains("[]") ? unit : "";
      return Stream.of(record)
          .filter(FieldRecord::hasAny)
          .map(it -> it.coverage(topic, path, own, writer));
    }
  }

  /** Creates an empty record. */
  public CoverageRecord(SimulatedChain chain) {
    this.chain = chain;
    chain.data().forEach(this::add);
  }

  private void add(String topic, List<Data> all) {
    Map<String, Field> fields = new LinkedHashMap<>();
    for (Data data : all) {
      String path = data.getFieldName();
      Optional<MessageType> type =
          Optional.ofNullable(data.getMessageType())
              .map(RosNames::fullMessageType)
              .flatMap(chain.catalog()::find);
      if (path != null && type.isPresent() && !isTime(type.get(), path)) {
        field(topic, type.get(), data).ifPresent(it -> fields.putIfAbsent(path, it));
      }
    }
    topics.put(topic, fields);
  }

  private static boolean isTime(MessageType type, String path) {
    int dot = path.lastIndexOf('.');
    return path.startsWith(HEADER)
        || (dot > 0
            && type.resolve(path.substring(0, dot)).type().stream()
                .flatMap(each -> each.message().stream())
                .anyMatch(each -> each.name().startsWith(TIME)));
  }

  private Optional<Field> field(String topic, MessageType message, Data data) {
    String path = data.getFieldName();
    Optional<FieldType> type = message.resolve(path).type();
    NamedValues names = chain.bench().signals().named(topic, message.name(), path);
    String unit = Objects.requireNonNullElse(data.getUnit(), "");
    return type.flatMap(
        it ->
            record(it, names, rest(data))
                .map(values -> new Field(unit, values, elements(topic, it))));
  }

  private static Optional<FieldRecord> record(FieldType type, NamedValues names, double rest) {
    Optional<Kind> kind =
        switch (type.shape()) {
          case SEQUENCE -> type.size() == 1 ? Optional.empty() : Optional.of(Kind.LIST);
          case ARRAY -> Optional.empty();
          case SINGLE -> single(type.kind(), names);
        };
    return kind.map(it -> new FieldRecord(it, names, rest));
  }

  private static Optional<Kind> single(FieldType.Kind kind, NamedValues names) {
    return switch (kind) {
      case BOOL -> Optional.of(Kind.TRUTH);
      case MESSAGE -> Optional.empty();
      case STRING -> names.isText() ? Optional.of(Kind.NAMED) : Optional.empty();
      default -> Optional.of(names.isEmpty() ? Kind.NUMBER : Kind.NAMED);
    };
  }

  private Map<String, FieldRecord> elements(String topic, FieldType list) {
    Map<String, FieldRecord> elements = new LinkedHashMap<>();
    if (list.shape() != FieldType.Shape.SEQUENCE) {
      return elements;
    }
    Optional<MessageType> message = list.message();
    message.ifPresent(
        type ->
            type.fields()
                .forEach(
                    each -> {
                      NamedValues names =
                          chain.bench().signals().named(topic, type.name(), each.name());
                      record(each.type(), names, 0.0)
                          .ifPresent(it -> elements.put(each.name(), it));
                    }));
    if (message.isEmpty() && !isBytesOrText(list.kind())) {
      Kind kind = list.kind() == FieldType.Kind.BOOL ? Kind.TRUTH : Kind.NUMBER;
      elements.put("", new FieldRecord(kind, NamedValues.NONE, 0.0));
    }
    return elements;
  }

  /** Returns whether elements are no values of their own, such as the bytes of an image. */
  private static boolean isBytesOrText(FieldType.Kind kind) {
    return switch (kind) {
      case STRING, BYTE, CHAR, UINT8, INT8 -> true;
      default -> false;
    };
  }

  /** Returns the number at rest: the safe value, or 0. */
  private static double rest(Data data) {
    try {
      return data.getSafeValue() == null ? 0.0 : Double.parseDouble(data.getSafeValue().trim());
    } catch (NumberFormatException e) {
      return 0.0;
    }
  }

  /** Adds a message of the vehicle or of a node. */
  public void add(String topic, MessageValue message) {
    topics.getOrDefault(topic, Map.of()).forEach((path, field) -> field.add(message, path));
  }

  /**
   * Returns what scenarios have shown together, in the order of the chain, with what they have not.
   *
   * @param records one for each scenario; none if nothing was recorded
   */
  public static List<SignalCoverage> of(
      SimulatedChain chain, Collection<CoverageRecord> records, Collection<Scenario> scenarios) {
    CoverageRecord all = new CoverageRecord(chain);
    records.forEach(all::addScenario);
    return new CoverageGaps(chain, scenarios, all.coverage()).marked();
  }

  private void addScenario(CoverageRecord scenario) {
    topics.forEach(
        (topic, fields) ->
            fields.forEach((path, field) -> field.add(scenario.topics.get(topic).get(path))));
  }

  private List<SignalCoverage> coverage() {
    List<SignalCoverage> all = new ArrayList<>();
    topics.forEach(
        (topic, fields) ->
            fields.forEach(
                (path, field) -> {
                  String writer = chain.isWritten(topic, path) ? chain.writer(topic) : "";
                  field.coverage(topic, path, writer).forEach(all::add);
                }));
    return all;
  }
}
