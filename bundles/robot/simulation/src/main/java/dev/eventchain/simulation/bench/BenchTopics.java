package dev.eventchain.simulation.bench;

import com.fasterxml.jackson.databind.JsonNode;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.RosNames;
import dev.eventchain.simulation.bench.Bench.Consumed;
import dev.eventchain.simulation.bench.Bench.Effect;
import dev.eventchain.simulation.bench.Bench.Provided;
import dev.eventchain.simulation.formula.Signal;
import dev.eventchain.simulation.sensor.LaserScanner;
import dev.eventchain.simulation.sensor.ObjectSensor;
import dev.eventchain.simulation.world.Actuator;
import java.util.ArrayList;
import java.util.Collection;
import java.util.EnumMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiConsumer;

/** Reads the sections {@code provides} and {@code consumes} of a bench. */
final class BenchTopics {

  private static final NumberRange RATE = NumberRange.of(0.1, 1000);
  private static final String SENSOR = "sensor";
  private static final String LIDAR = "lidar";
  private static final String OBJECTS = "objects";
  private static final String LASER_SCAN = "laser_scan";
  private static final String LATENCY_KEY = "latency_ms";
  private static final String COUNTED = "latency_counts_in";
  private static final NumberRange LATENCY = NumberRange.of(0, 2000);
  private static final String POINT_CLOUD = "sensor_msgs/msg/PointCloud2";

  private final DeclaredSignals declared;
  private final Optional<MessageCatalog> catalog;
  private final BenchFields fields;
  private final BenchEffects effects;

  /** Location of the name of the topic being read. */
  private SourceLocation place = SourceLocation.NONE;

  private final Map<Actuator, Effect> driven = new EnumMap<>(Actuator.class);

  /**
   * Creates a reader.
   *
   * @param catalog the message types; empty to leave their check to a simulation
   * @param inputs the inputs that values may depend on besides the world
   */
  BenchTopics(
      DeclaredSignals declared,
      Optional<MessageCatalog> catalog,
      Collection<Signal> inputs,
      YamlText source) {
    this.declared = declared;
    this.catalog = catalog;
    this.fields = new BenchFields(declared, inputs, source);
    this.effects = new BenchEffects(declared, fields);
  }

  /** Reads both sections into maps by the topics' full names. */
  void read(ObjectReader section, Map<String, Provided> provided, Map<String, Consumed> consumed) {
    section
        .object("provides")
        .ifPresent(
            part -> topics(part, (name, topic) -> provided.put(name, provided(topic, name))));
    section
        .object("consumes")
        .ifPresent(
            part -> topics(part, (name, topic) -> consumed.put(name, consumed(topic, name))));
    section.refuseOthers();
  }

  /** Reads each topic of a section once, by its full name. */
  private void topics(ObjectReader part, BiConsumer<String, ObjectReader> reader) {
    Set<String> read = new HashSet<>();
    for (String written : part.names()) {
      Optional<ObjectReader> topic = part.object(written);
      String name = BenchReader.fullName(written);
      if (!RosNames.isTopic(written) || RosNames.isPrivate(written)) {
        String message = "'" + written + "' is not the name of a topic.";
        part.find(BenchRules.BENCH_VALUE_RANGE, message, part.atKey(written));
      } else if (!read.add(name)) {
        String message = "The topic " + name + " is duplicated.";
        part.find(BenchRules.BENCH_KEY_DUPLICATE, message, part.atKey(written));
      } else {
        place = part.atKey(written);
        topic.ifPresent(section -> reader.accept(name, section));
      }
    }
  }

  private Provided provided(ObjectReader section, String topic) {
    double rate = section.requiredNumber("rate_hz", RATE);
    boolean lidar = isLidar(section);
    boolean scans = section.has(LASER_SCAN);
    String type = type(section, topic, lidar ? POINT_CLOUD : scans ? LaserScanReader.MESSAGES : "");
    Optional<MessageType> message = message(section, type);
    List<Bench.Field> read = new ArrayList<>();
    section
        .object("fields")
        .ifPresent(
            part ->
                part.names()
                    .forEach(path -> fields.read(part, topic, path, message).ifPresent(read::add)));
    Optional<ObjectSensor> objects =
        section.object(OBJECTS).map(part -> new ObjectsReader(declared, topic, message).read(part));
    Optional<LaserScanner> scanner =
        section.object(LASER_SCAN).map(part -> LaserScanReader.read(part, rate));
    Transfer transfer = transfer(section);
    if (isEmpty(section) && !section.has(SENSOR) && !section.has(OBJECTS) && !scans) {
      section.find(
          BenchRules.BENCH_KEY_MISSING,
          "No field of " + topic + " has a source.",
          section.location());
    }
    SensorConflicts.refuse(section, read, objects, scanner);
    section.refuseOthers();
    return new Provided(topic, type, rate, lidar, objects, scanner, read, transfer, place);
  }

  private Transfer transfer(ObjectReader section) {
    double latency = section.number(LATENCY_KEY, LATENCY).orElse(0);
    List<String> counted = section.texts(COUNTED);
    if (!counted.isEmpty() && latency == 0.0) {
      section.find(
          BenchRules.BENCH_KEY_MISSING,
          "There is no `latency_ms` that latency constraints could count.",
          section.atKey(COUNTED));
    }
    return new Transfer(Math.round(latency * 1e6), fields.part(section, "lost"), counted);
  }

  private static boolean isEmpty(ObjectReader section) {
    return section.value("fields").map(JsonNode::isEmpty).orElse(true);
  }

  private static boolean isLidar(ObjectReader section) {
    Optional<String> sensor = section.text(SENSOR);
    if (sensor.isPresent() && !sensor.get().equals(LIDAR)) {
      section.find(
          Diagnostic.of(
                  BenchRules.BENCH_VALUE_RANGE,
                  "There is no sensor '" + sensor.get() + "'.",
                  section.at(SENSOR))
              .withHint("The sensors are: " + LIDAR + ". Others are built from quantities."));
    }
    return sensor.filter(LIDAR::equals).isPresent();
  }

  /** Returns the type of a topic's messages; bench and project must agree on it. */
  private String type(ObjectReader section, String topic, String usual) {
    Optional<String> written = section.text("type").map(RosNames::fullMessageType);
    Optional<String> known =
        declared.find(topic).map(signal -> RosNames.fullMessageType(signal.messageType()));
    if (written.isEmpty() && known.isEmpty() && usual.isEmpty()) {
      section.find(
          BenchRules.BENCH_KEY_MISSING,
          "'type' is missing, and signals.json says nothing about " + topic + ".",
          section.location());
      return "";
    }
    String type = written.or(() -> known).orElse(usual);
    String expected = known.orElse(usual.isEmpty() ? type : usual);
    if (!type.equals(expected) || (!usual.isEmpty() && !type.equals(usual))) {
      section.find(
          Diagnostic.of(
                  BenchRules.BENCH_TYPE,
                  "The messages of "
                      + topic
                      + " are "
                      + type
                      + " here, but "
                      + (known.isEmpty() || type.equals(expected)
                          ? usual + (lidarType(usual) ? " for a lidar." : " for a laser scanner.")
                          : expected + " in signals.json."),
                  section.has("type") ? section.at("type") : section.location())
              .withHint("Write the same type in both."));
    }
    return type;
  }

  private static boolean lidarType(String type) {
    return type.equals(POINT_CLOUD);
  }

  private Optional<MessageType> message(ObjectReader section, String type) {
    if (catalog.isEmpty() || type.isEmpty()) {
      return Optional.empty();
    }
    try {
      Optional<MessageType> found = catalog.get().find(type);
      if (found.isEmpty()) {
        section.find(
            Diagnostic.of(
                    BenchRules.MESSAGE_UNKNOWN,
                    "There is no message type " + type + ".",
                    section.has("type") ? section.at("type") : section.location())
                .withHint(
                    (catalog.get().hintOfDistribution(type, "")
                            + NearestName.hint(type, catalog.get().names()))
                        .strip()));
      }
      return found;
    } catch (DiagnosticException e) {
      e.diagnostics().forEach(section::find);
      return Optional.empty();
    }
  }

  private Consumed consumed(ObjectReader section, String topic) {
    String type = type(section, topic, "");
    Optional<MessageType> message = message(section, type);
    List<Effect> read = new ArrayList<>();
    section
        .object("fields")
        .ifPresent(
            part ->
                part.names()
                    .forEach(
                        path ->
                            effects
                                .read(part, topic, path, message)
                                .ifPresent(effect -> add(part, effect, read))));
    boolean observed = section.has("observed");
    section.requireTrue("observed");
    if (isEmpty(section) && !observed) {
      section.find(
          Diagnostic.of(
                  BenchRules.BENCH_KEY_MISSING,
                  "No field of " + topic + " does anything.",
                  section.location())
              .withHint("Write `observed: true` if the vehicle only receives it."));
    }
    section.refuseOthers();
    return new Consumed(topic, type, read, place);
  }

  private void add(ObjectReader part, Effect effect, List<Effect> read) {
    read.add(effect);
    if (effect.actuator().isEmpty()) {
      return;
    }
    Actuator actuator = effect.actuator().get();
    for (Map.Entry<Actuator, Effect> other : driven.entrySet()) {
      if (actuator.excludes(other.getKey())) {
        part.find(
            Diagnostic.of(
                    BenchRules.BENCH_ACTUATOR_CONFLICT,
                    "'%s' drives %s, but '%s' at %s drives %s already."
                        .formatted(
                            effect.path(),
                            actuator.id(),
                            other.getValue().path(),
                            other.getValue().location(),
                            other.getKey().id()),
                    effect.location())
                .withHint("Mark one of them as `observed`."));
        return;
      }
    }
    driven.put(actuator, effect);
  }
}
