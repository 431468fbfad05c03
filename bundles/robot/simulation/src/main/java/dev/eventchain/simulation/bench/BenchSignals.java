package dev.eventchain.simulation.bench;

import dev.eventchain.messages.FieldType;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.Unit;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.simulation.formula.NamedValues;
import dev.eventchain.simulation.formula.Range;
import dev.eventchain.simulation.formula.Signal;
import dev.eventchain.simulation.formula.WorldSignals;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Pattern;

/**
 * Signals that formulas may read: the world, the inputs of the bench, and each field of each known
 * topic, as {@code /topic.field}. A field without a unit is read as a plain number.
 */
public final class BenchSignals implements Signal.Source {

  /** A topic with fields that formulas read. */
  public record Topic(String name, String type, Map<String, String> units) {}

  /** Meaning of inputs that are not computed. */
  static final String SCRIPTED = "set by scenarios";

  /** Other forms of the pose and its changes, for messages: reported only where they are read. */
  private static final Pattern OTHER_FORM =
      Pattern.compile("ego\\.(x|y|yaw|latitude|longitude|orientation\\..|acceleration\\.(.|left))");

  private static final WorldSignals WORLD = new WorldSignals();

  private final Map<String, Signal> inputs;
  private final Map<String, Topic> topics;
  private final MessageCatalog catalog;
  private final FieldNames names;
  private final Optional<OutputRoles> roles;

  BenchSignals(
      Map<String, Signal> inputs,
      Map<String, Topic> topics,
      MessageCatalog catalog,
      FieldNames names,
      Optional<OutputRoles> roles) {
    this.inputs = new LinkedHashMap<>(inputs);
    this.topics = new LinkedHashMap<>(topics);
    this.catalog = catalog;
    this.names = names;
    this.roles = roles;
  }

  /** Returns these signals with the outputs of a chain by their requirements. */
  BenchSignals withOutputsOf(EventChain chain) {
    OutputRoles outputs = new OutputRoles(chain, catalog, names);
    return new BenchSignals(inputs, topics, catalog, names, Optional.of(outputs));
  }

  /** Returns the definitions of the topics' types. */
  MessageCatalog catalog() {
    return catalog;
  }

  @Override
  public Optional<List<Signal>> outputs(String requirement, Optional<String> kind) {
    return roles.map(known -> known.find(requirement, kind));
  }

  @Override
  public Optional<Signal> find(String name) {
    return name.startsWith("/")
        ? ofTopic(name)
        : WORLD.find(name).or(() -> Optional.ofNullable(inputs.get(name)));
  }

  @Override
  public Collection<String> names() {
    List<String> names = new ArrayList<>(WORLD.names());
    names.addAll(inputs.keySet());
    topics.values().forEach(topic -> names.addAll(fields(topic)));
    return names;
  }

  /** Returns the inputs that a scenario may set, by name. */
  public Map<String, Signal> inputs() {
    return inputs;
  }

  /** Returns whether a scenario may script an input. */
  public boolean isScripted(String name) {
    return inputs.containsKey(name) && inputs.get(name).meaning().equals(SCRIPTED);
  }

  /** Returns the names of the inputs that a scenario may set. */
  public List<String> scripted() {
    return inputs.keySet().stream().filter(this::isScripted).toList();
  }

  /**
   * Returns the signals that a report shows for a scenario, by name: the world, the inputs, and
   * those that formulas read.
   *
   * @param read signals read by the formulas of the scenario
   */
  public List<Signal> reported(Collection<Signal> read) {
    Map<String, Signal> reported = new TreeMap<>();
    WorldSignals.all().stream()
        .filter(signal -> !OTHER_FORM.matcher(signal.name()).matches())
        .forEach(signal -> reported.put(signal.name(), signal));
    reported.putAll(inputs);
    read.forEach(signal -> reported.put(signal.name(), signal));
    return List.copyOf(reported.values());
  }

  /** Returns the topic of a signal that is a field; empty for any other signal. */
  public Optional<Topic> topicOf(Signal signal) {
    return signal.topic().flatMap(this::topic);
  }

  private Optional<Topic> topic(String name) {
    return Optional.ofNullable(topics.get(name))
        .or(() -> roles.flatMap(known -> known.topic(name)));
  }

  private List<String> fields(Topic topic) {
    return topic.units().keySet().stream()
        .map(field -> topic.name() + "." + field)
        .filter(name -> ofTopic(name).isPresent())
        .toList();
  }

  private Optional<Signal> ofTopic(String name) {
    Topic topic = topics.get(Signal.topicOf(name));
    if (topic == null || name.indexOf('.') < 0) {
      return Optional.empty();
    }
    String path = name.substring(name.indexOf('.') + 1);
    Optional<MessageType> type = catalog.find(topic.type());
    return type.flatMap(known -> known.resolve(path).type())
        .flatMap(field -> readable(topic, path, field, names));
  }

  /** Returns the signal of a field that is a single number or Boolean, or one of known texts. */
  static Optional<Signal> readable(Topic topic, String path, FieldType field, FieldNames names) {
    NamedValues named = names.of(topic.name(), topic.type(), path);
    boolean isText = field.kind() == FieldType.Kind.STRING && named.isText() && !named.isEmpty();
    return isNumberOrTruth(field) || (isText && field.shape() == FieldType.Shape.SINGLE)
        ? Optional.of(signal(topic, path, field.kind() == FieldType.Kind.BOOL).withNames(named))
        : Optional.empty();
  }

  /** Returns the names of the values of a topic's field. */
  public NamedValues named(String topic, String type, String path) {
    return names.of(topic, type, path);
  }

  /** Returns the values that a field of a topic can have, in coherent units: those of its type. */
  public Range rangeOf(String signal) {
    Optional<Topic> topic = topic(Signal.topicOf(signal));
    int dot = signal.indexOf('.');
    if (topic.isEmpty() || dot < 0) {
      return Range.ALL;
    }
    String path = signal.substring(dot + 1);
    return catalog
        .find(topic.get().type())
        .flatMap(type -> type.resolve(path).type())
        .filter(BenchSignals::isNumberOrTruth)
        .map(field -> coherent(rangeOf(field.kind()), signal(topic.get(), path, false)))
        .orElse(Range.ALL);
  }

  private static Range coherent(Range range, Signal signal) {
    Unit unit = signal.dimension();
    return new Range(unit.coherent(range.least()), unit.coherent(range.most()));
  }

  private static Range rangeOf(FieldType.Kind kind) {
    return switch (kind) {
      case BOOL -> Range.upTo(1.0);
      case BYTE, CHAR, UINT8 -> Range.upTo(255.0);
      case UINT16 -> Range.upTo(65535.0);
      case UINT32 -> Range.upTo(4294967295.0);
      case UINT64 -> Range.upTo(0x1p64);
      case INT8 -> new Range(-128.0, 127.0);
      case INT16 -> new Range(-32768.0, 32767.0);
      case INT32 -> new Range(-2147483648.0, 2147483647.0);
      default -> Range.ALL;
    };
  }

  /** Returns the signal of a topic's field, in the unit that is known of it. */
  static Signal signal(Topic topic, String path, boolean truth) {
    String unit = topic.units().getOrDefault(path, "");
    boolean known = !unit.isEmpty() && Unit.parse(unit).isPresent();
    return ofField(topic.name(), path, topic.type(), known ? unit : "1", truth);
  }

  /** Returns the signal of a topic's field. */
  public static Signal ofField(String topic, String path, String type, String unit, boolean truth) {
    String name = topic + "." + path;
    return new Signal(
        name,
        unit,
        truth,
        "field of " + type,
        trace -> Signal.held(trace, trace.samples(name), Double.NaN),
        trace ->
            trace.samples(name).isEmpty()
                ? Optional.of("nothing came on " + topic)
                : Optional.empty());
  }

  /** Returns whether a field is a single number or Boolean. */
  public static boolean isNumberOrTruth(FieldType type) {
    return type.shape() == FieldType.Shape.SINGLE
        && switch (type.kind()) {
          case STRING, MESSAGE -> false;
          default -> true;
        };
  }
}
