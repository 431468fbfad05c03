package dev.eventchain.simulation.bench;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.NearestName;
import dev.eventchain.diagnostics.ResourceText;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.DocumentRules;
import dev.eventchain.documents.ObjectReader;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.RosNames;
import dev.eventchain.model.Signal.Direction;
import dev.eventchain.simulation.bench.Bench.Consumed;
import dev.eventchain.simulation.bench.Bench.Provided;
import dev.eventchain.simulation.formula.Signal;
import dev.eventchain.simulation.world.Actuator;
import dev.eventchain.simulation.world.EgoVehicle;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;

/** Reads {@code bench.yaml} and the bench that it extends. */
public final class BenchReader {

  private static final String RESOURCES = "/dev/eventchain/simulation/";

  private static final DocumentRules RULES =
      new DocumentRules(
          BenchRules.BENCH_SYNTAX,
          BenchRules.BENCH_KEY_DUPLICATE,
          BenchRules.BENCH_VALUE_TYPE,
          BenchRules.BENCH_KEY_MISSING,
          BenchRules.BENCH_KEY_UNKNOWN,
          BenchRules.BENCH_VALUE_RANGE);
  private static final String CARLA = "carla";

  private final DeclaredSignals declared;
  private final MessageCatalog catalog;
  private final List<Diagnostic> problems = new ArrayList<>();
  private final Map<String, Provided> provided = new LinkedHashMap<>();
  private final Map<String, Consumed> consumed = new LinkedHashMap<>();
  private final Set<String> own = new LinkedHashSet<>();
  private final Map<String, Signal> inputs = new LinkedHashMap<>();
  private final Set<String> stated = new LinkedHashSet<>();
  private EgoVehicle vehicle = EgoVehicle.withSpeed(0);
  private SourceLocation speedStep = SourceLocation.NONE;
  private SourceLocation turning = SourceLocation.NONE;

  private BenchReader(DeclaredSignals declared, MessageCatalog catalog) {
    this.declared = declared;
    this.catalog = catalog;
  }

  /** Reads a bench as {@link Bench#read} does. */
  static Bench read(Optional<Path> file, DeclaredSignals declared, MessageCatalog messages) {
    BenchReader reader = new BenchReader(declared, messages);
    if (file.isPresent()) {
      reader.project(SourceText.read(file.get()));
    } else {
      reader.carla();
    }
    return reader.finished(file.map(SourceLocation::of).orElse(SourceLocation.NONE));
  }

  /** Reads a bench in memory likewise. */
  static Bench parse(SourceText text, DeclaredSignals declared, MessageCatalog messages) {
    BenchReader reader = new BenchReader(declared, messages);
    reader.project(text);
    return reader.finished(SourceLocation.of(text.name()));
  }

  private Bench finished(SourceLocation location) {
    if (!problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, problems);
    }
    return bench(location);
  }

  private Bench bench(SourceLocation location) {
    FieldNames names = new FieldNames(declared, catalog);
    BenchSignals signals = new BenchSignals(inputs, topics(), catalog, names, Optional.empty());
    return new Bench(provided, consumed, own, signals, declared, vehicle, location);
  }

  /** Returns the known topics: those of the bench and those that the project declares. */
  private Map<String, BenchSignals.Topic> topics() {
    Map<String, BenchSignals.Topic> topics = new TreeMap<>();
    for (String name : declared.names()) {
      dev.eventchain.model.Signal signal = declared.find(name).orElseThrow();
      Map<String, String> units = new LinkedHashMap<>();
      signal.fields().forEach(field -> units.put(field.path(), field.unit()));
      topics.put(name, new BenchSignals.Topic(name, signal.messageType(), units));
    }
    consumed.forEach(
        (name, topic) -> {
          Map<String, String> units = new LinkedHashMap<>();
          topic.fields().forEach(field -> units.put(field.path(), field.unit()));
          if (topics.containsKey(name)) {
            Map<String, String> said = topics.get(name).units();
            units.forEach((path, unit) -> said.merge(path, unit, (a, b) -> a.isEmpty() ? b : a));
          } else {
            topics.put(name, new BenchSignals.Topic(name, topic.type(), units));
          }
        });
    return topics;
  }

  private void carla() {
    SourceText text = SourceText.of("carla.yaml", resource("carla.yaml"));
    Document document = Document.parse(text, DocumentFormat.YAML, RULES, problems::add);
    ObjectReader section = document.object("", problems::add).orElseThrow();
    // Projects without CARLA's topics need not have its message types.
    new BenchTopics(declared, Optional.empty(), inputs.values(), new YamlText(text))
        .read(section, provided, consumed);
  }

  /** Returns the text of a resource of this bundle. */
  public static String resource(String name) {
    return ResourceText.of(BenchReader.class, RESOURCES + name);
  }

  private void project(SourceText text) {
    Document document = Document.parse(text, DocumentFormat.YAML, RULES, problems::add);
    YamlText source = new YamlText(text);
    document.object("", problems::add).ifPresent(section -> project(section, source));
  }

  private void project(ObjectReader section, YamlText source) {
    Optional<String> base = section.text("extends");
    if (base.isPresent() && !base.get().equals(CARLA)) {
      section.find(
          Diagnostic.of(
                  BenchRules.BENCH_VALUE_RANGE,
                  "There is no bench '" + base.get() + "' to extend.",
                  section.at("extends"))
              .withHint("Write `extends: carla`, or leave it out."));
    }
    section.object("vehicle").ifPresent(this::vehicle);
    section.object("inputs").ifPresent(part -> inputs.putAll(BenchInputs.read(part, source)));
    if (!problems.isEmpty()) {
      return; // Values that need a refused input would be refused as well.
    }
    if (base.isPresent()) {
      carla();
    }
    Map<String, Provided> ownProvided = new LinkedHashMap<>();
    Map<String, Consumed> ownConsumed = new LinkedHashMap<>();
    new BenchTopics(declared, Optional.of(catalog), inputs.values(), source)
        .read(section, ownProvided, ownConsumed);
    ownProvided.forEach((topic, read) -> checkTopic(topic, read.location(), Direction.PROVIDED));
    ownConsumed.forEach((topic, read) -> checkTopic(topic, read.location(), Direction.CONSUMED));
    own.addAll(ownProvided.keySet());
    own.addAll(ownConsumed.keySet());
    checkSpeed(ownConsumed);
    provided.putAll(ownProvided);
    consumed.putAll(ownConsumed);
  }

  /** Checks that a bench whose vehicle follows a speed says how it does, and until when. */
  private void checkSpeed(Map<String, Consumed> read) {
    Optional<Bench.Effect> speed = effect(read, Actuator.SPEED);
    Optional<Bench.Effect> yawRate = effect(read, Actuator.YAW_RATE);
    if (yawRate.isPresent() && speed.isEmpty()) {
      problems.add(
          Diagnostic.of(
                  BenchRules.BENCH_KEY_MISSING,
                  "'%s' drives yaw_rate, and no field drives the speed beside it."
                      .formatted(yawRate.get().path()),
                  yawRate.get().location())
              .withHint("Let a field drive `speed`, or drive `steering_angle` instead."));
    }
    refuseWithoutEffect(speed, yawRate);
    List<String> missing =
        VehicleReader.FOLLOWING.stream().filter(it -> !stated.contains(it)).toList();
    if (speed.isPresent() && !missing.isEmpty()) {
      problems.add(
          Diagnostic.of(
                  BenchRules.BENCH_KEY_MISSING,
                  "'%s' drives the speed, and `vehicle` does not say how it follows that: %s."
                      .formatted(speed.get().path(), String.join(", ", missing)),
                  speed.get().location())
              .withHint(
                  "Write them under `vehicle`: the limits of its acceleration, and how long a command"
                      + " holds before it stops by itself, which is 0 if it never does."));
    }
  }

  /** Refuses what the bench says of a vehicle whose motion does not depend on it. */
  private void refuseWithoutEffect(Optional<Bench.Effect> speed, Optional<Bench.Effect> yawRate) {
    if (speed.isPresent() && vehicle.speedStep() > 0.0) {
      problems.add(
          Diagnostic.of(
                  BenchRules.BENCH_ACTUATOR_CONFLICT,
                  "The speed changes in steps here, but '%s' drives it, which it follows continuously."
                      .formatted(speed.get().path()),
                  speedStep)
              .withHint("Leave `speed_step_s` out."));
    }
    if (yawRate.isEmpty() && vehicle.chassis().turnsOnTheSpot()) {
      problems.add(
          Diagnostic.of(
                  BenchRules.BENCH_KEY_MISSING,
                  "The vehicle turns on the spot, and no field drives its yaw_rate.",
                  turning)
              .withHint("Let a field drive `yaw_rate`, or leave `maximal_yaw_rate_radps` out."));
    }
  }

  private static Optional<Bench.Effect> effect(Map<String, Consumed> read, Actuator actuator) {
    return read.values().stream()
        .flatMap(topic -> topic.fields().stream())
        .filter(each -> each.actuator().equals(Optional.of(actuator)))
        .findFirst();
  }

  private void vehicle(ObjectReader section) {
    VehicleReader.FOLLOWING.stream().filter(section::has).forEach(stated::add);
    vehicle = VehicleReader.read(section, vehicle, 0, BenchRules.BENCH_VALUE_RANGE);
    speedStep = section.at(VehicleReader.SPEED_STEP);
    turning = section.at(VehicleReader.YAW_RATE);
    section.refuseOthers();
  }

  private void checkTopic(String topic, SourceLocation place, Direction direction) {
    String wanted = direction == Direction.PROVIDED ? "provided" : "consumed";
    boolean isDeclared =
        declared.find(topic).filter(signal -> signal.direction() == direction).isPresent();
    if (declared.isEmpty() || isDeclared || isOfItsOwn(topic, direction)) {
      return;
    }
    problems.add(
        Diagnostic.of(
                BenchRules.BENCH_TOPIC_UNKNOWN,
                "signals.json has no " + wanted + " signal " + topic + ".",
                place)
            .withHint(NearestName.hint(topic, declared.names(direction))));
  }

  /**
   * Returns whether an undeclared consumed topic may be observed, and is not a misspelt declared
   * one.
   */
  private boolean isOfItsOwn(String topic, Direction direction) {
    return direction == Direction.CONSUMED
        && declared.find(topic).isEmpty()
        && NearestName.of(topic, declared.names()).isEmpty();
  }

  /** Returns the full name of a topic. */
  static String fullName(String topic) {
    return RosNames.resolve(topic, "");
  }
}
