package dev.eventchain.simulation.bench;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageValue;
import dev.eventchain.messages.QosSettings;
import dev.eventchain.messages.Unit;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.simulation.formula.Formula;
import dev.eventchain.simulation.formula.SampledRun;
import dev.eventchain.simulation.formula.Signal;
import dev.eventchain.simulation.formula.Term;
import dev.eventchain.simulation.sensor.LaserScanner;
import dev.eventchain.simulation.sensor.ObjectSensor;
import dev.eventchain.simulation.world.Actuator;
import dev.eventchain.simulation.world.EgoVehicle;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.function.Function;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EObject;

/**
 * Connection of the simulated road with the software: the source of each field of the topics that
 * the vehicle provides, and the effect of each field of the topics that it consumes. Read from
 * {@code bench.yaml}; a project without one has the topics of the CARLA ROS bridge. Immutable.
 */
public final class Bench {

  /** Source of a published value. */
  public sealed interface Source permits Constant, Quantity, Truth, ChosenText {

    /** Returns an example value of the published kind. */
    Object example();

    /** Returns the signals that the value depends on. */
    default Set<Signal> signals() {
      return Set.of();
    }
  }

  /** A constant, in the form that {@link dev.eventchain.messages.MessageValue} accepts. */
  record Constant(Object value) implements Source {

    @Override
    public Object example() {
      return value;
    }
  }

  /**
   * A quantity of the world.
   *
   * @param text the source text
   * @param unit the unit of the field
   * @param absent the published value if the quantity has no value
   * @param noise standard deviation of the published value, in the field's unit
   */
  public record Quantity(String text, Term term, Unit unit, double absent, double noise)
      implements Source {

    /**
     * The value in the field's unit.
     *
     * @param random the source of the noise; unused if there is none
     */
    public double at(SampledRun moment, SplittableRandom random) {
      double value = term.values().in(moment).applyAsDouble(0);
      if (Double.isNaN(value)) {
        return absent;
      }
      return unit.ofCoherent(value) + (noise > 0.0 ? noise * random.nextGaussian() : 0.0);
    }

    /** Returns a copy with noise. */
    Quantity withNoise(double deviation) {
      return new Quantity(text, term, unit, absent, deviation);
    }

    @Override
    public Object example() {
      return 0;
    }

    @Override
    public Set<Signal> signals() {
      return term.signals();
    }
  }

  /** A formula that is published as a Boolean. */
  public record Truth(String text, Formula formula) implements Source {

    @Override
    public Object example() {
      return false;
    }

    @Override
    public Set<Signal> signals() {
      return formula.signals();
    }
  }

  /** A published field. */
  public record Field(String path, Source source, SourceLocation location) {}

  /**
   * A topic that the vehicle provides.
   *
   * @param type the full name of the message type
   * @param rate in Hz
   * @param lidar true if its messages are the scans of the roof lidar
   * @param objects the sensor of the objects that its messages list
   * @param scanner the scanner whose scans its messages are
   * @param transfer the transfer of its messages to the nodes
   */
  public record Provided(
      String topic,
      String type,
      double rate,
      boolean lidar,
      Optional<ObjectSensor> objects,
      Optional<LaserScanner> scanner,
      List<Field> fields,
      Transfer transfer,
      SourceLocation location) {

    /** Returns the period, in ns. */
    public long period() {
      return Math.round(1e9 / rate);
    }

    private Provided later(long delay) {
      return new Provided(
          topic, type, rate, lidar, objects, scanner, fields, transfer.later(delay), location);
    }

    /** Returns whether its messages are scans, all of whose fields have values. */
    boolean scans() {
      return lidar || scanner.isPresent();
    }

    /** Returns the fields of its messages that get values, unless they are scans. */
    Stream<String> paths() {
      return Stream.concat(
          fields.stream().map(Field::path), objects.stream().flatMap(it -> it.paths().stream()));
    }
  }

  /**
   * Effect of a field that the vehicle consumes.
   *
   * @param actuator the actuator; empty if the field is only observed
   * @param unit the unit of the field
   * @param required true if the software must write it
   */
  public record Effect(
      String path,
      Optional<Actuator> actuator,
      String unit,
      boolean required,
      SourceLocation location) {

    /**
     * Checks that a message has the field, of the kind that the actuator needs.
     *
     * @throws IllegalArgumentException if the field is missing or of another kind
     */
    public void check(MessageValue message) {
      boolean isTruth = message.get(path) instanceof Boolean;
      if (actuator.isPresent() && actuator.get().truth() != isTruth) {
        throw new IllegalArgumentException(
            "'%s' cannot drive %s.".formatted(path, actuator.get().id()));
      }
    }

    /** Converts a value of the field into the actuator's unit. */
    public double demand(double value) {
      double coherent = Unit.parse(unit).orElseThrow().coherent(value);
      return actuator.orElseThrow().unit().ofCoherent(coherent);
    }
  }

  /** A topic that the vehicle consumes. */
  public record Consumed(String topic, String type, List<Effect> fields, SourceLocation location) {

    /** Returns whether a field of it drives an actuator. */
    public boolean commands() {
      return fields.stream().anyMatch(field -> field.actuator().isPresent());
    }
  }

  private final Map<String, Provided> provided;
  private final Map<String, Consumed> consumed;
  private final Set<String> own;
  private final BenchSignals signals;
  private final DeclaredSignals declared;
  private final EgoVehicle vehicle;
  private final SourceLocation location;

  Bench(
      Map<String, Provided> provided,
      Map<String, Consumed> consumed,
      Set<String> own,
      BenchSignals signals,
      DeclaredSignals declared,
      EgoVehicle vehicle,
      SourceLocation location) {
    this.provided = provided;
    this.consumed = consumed;
    this.own = Set.copyOf(own);
    this.signals = signals;
    this.declared = declared;
    this.vehicle = vehicle;
    this.location = location;
  }

  /**
   * Reads a bench.
   *
   * @param file {@code bench.yaml}; empty if the project has none
   * @param declared the project's signals
   * @param messages the definitions of the topics' types
   * @throws DiagnosticException (INPUT) with every problem of the file: {@code bench.syntax},
   *     {@code bench.key.*}, {@code bench.value.*}, {@code bench.formula.*}, {@code bench.unit},
   *     {@code bench.topic.unknown}, {@code bench.type}, {@code bench.actuator.unknown}, {@code
   *     bench.actuator.conflict}, {@code bench.input.cycle}, {@code message.unknown}, {@code
   *     message.field.missing}
   */
  public static Bench read(
      Optional<Path> file, List<dev.eventchain.model.Signal> declared, MessageCatalog messages) {
    return BenchReader.read(file, new DeclaredSignals(declared), messages);
  }

  /** Reads a text in memory as {@link #read} does a file. */
  public static Bench parse(
      SourceText text, List<dev.eventchain.model.Signal> declared, MessageCatalog messages) {
    return BenchReader.parse(text, new DeclaredSignals(declared), messages);
  }

  /** Returns a bench with the topics of the CARLA ROS bridge, for software with unknown signals. */
  public static Bench carla() {
    return read(Optional.empty(), List.of(), MessageCatalog.of(List.of()));
  }

  /**
   * Checks whether a chain fits the bench. Each topic and field that it reads from the vehicle
   * needs a source. Each topic that it writes to the vehicle must be consumed, and each required
   * field written.
   *
   * @param locator the places of the chain's elements
   * @return {@code bench.topic.unconnected}, {@code bench.field.unset}, {@code
   *     bench.field.unwritten}, {@code bench.type}, {@code bench.unit}
   */
  public List<Diagnostic> check(EventChain chain, Function<EObject, SourceLocation> locator) {
    return new BenchCheck(this, chain, locator).check();
  }

  /**
   * Returns a listing, for users, of the topics that the world provides and consumes, and of a
   * project's connections with them.
   *
   * @param chain the project's chain, if there is one
   */
  public String listing(Optional<EventChain> chain) {
    return new BenchListing(this, chain).text();
  }

  /**
   * Returns a {@code bench.yaml} for a project that has none, with the known rates of topics in Hz.
   * Fields recognised by name and unit are connected; the rest is in comments.
   */
  public static String proposal(
      List<dev.eventchain.model.Signal> declared,
      MessageCatalog messages,
      Map<String, Double> rates) {
    return new BenchProposal(declared, messages, rates).text();
  }

  /** Returns the JSON Schema of {@code bench.yaml}. */
  public static String schema() {
    return BenchReader.resource("bench.schema.json");
  }

  /** Returns the provided topics, by their full names. */
  public Map<String, Provided> provided() {
    return provided;
  }

  /** Returns the consumed topics, by their full names. */
  public Map<String, Consumed> consumed() {
    return consumed;
  }

  /** Returns whether a published value depends on an input. */
  public boolean mayNeed(String input) {
    return provided.values().stream()
        .flatMap(
            topic ->
                Stream.concat(
                    topic.transfer().signals().stream(),
                    topic.fields().stream().flatMap(field -> field.source().signals().stream())))
        .flatMap(Signal::origins)
        .anyMatch(signal -> signal.name().equals(input));
  }

  /**
   * Returns this bench for a chain, so that formulas can read its outputs by the requirements that
   * they satisfy.
   */
  public Bench withOutputsOf(EventChain chain) {
    BenchSignals known = signals.withOutputsOf(chain);
    return new Bench(provided, consumed, own, known, declared, vehicle, location);
  }

  /** Returns this bench with messages that take longer to the nodes, by a delay in ns. */
  public Bench later(long delay) {
    Map<String, Provided> delayed = new LinkedHashMap<>(provided);
    delayed.replaceAll((topic, each) -> each.later(delay));
    return new Bench(delayed, consumed, own, signals, declared, vehicle, location);
  }

  /** Returns the vehicle of the project, which stands still in the middle of its lane. */
  public EgoVehicle vehicle() {
    return vehicle;
  }

  /** Returns the signals that formulas may read. */
  public BenchSignals signals() {
    return signals;
  }

  /**
   * Returns whether the project names a topic in its own bench or in its signals; always true for a
   * project that names no topic.
   */
  public boolean isOwn(String topic) {
    boolean nothingSaid = own.isEmpty() && declared.isEmpty();
    return nothingSaid || own.contains(topic) || declared.find(topic).isPresent();
  }

  /**
   * Returns the QoS that the vehicle offers on a topic that it provides: as declared, otherwise the
   * default of ROS 2. All policies are decided.
   *
   * @param topic its full name
   */
  public QosSettings offered(String topic) {
    return VehicleQos.offered(declared.quality(topic));
  }

  /**
   * Returns the QoS that the vehicle requests on a topic that it consumes; as {@link #offered}.
   *
   * @param topic its full name
   */
  public QosSettings requested(String topic) {
    return VehicleQos.requested(declared.quality(topic));
  }

  /** Returns the fields of a topic whose signal states which values they have. */
  public List<dev.eventchain.model.Signal.Field> limited(String topic) {
    return declared.limited(topic);
  }

  DeclaredSignals declared() {
    return declared;
  }

  /** Returns whether a field of a topic drives an actuator. */
  public boolean drives(Actuator actuator) {
    return consumed.values().stream()
        .flatMap(topic -> topic.fields().stream())
        .anyMatch(effect -> effect.actuator().equals(Optional.of(actuator)));
  }

  /** Returns what a proposal would say of the fields of a topic; none if it is not declared. */
  List<String> guesses(String topic) {
    BenchProposal proposal = new BenchProposal(List.of(), signals.catalog(), Map.of());
    return declared.find(topic).map(proposal::guesses).orElse(List.of());
  }

  /** Returns the location of the file; empty if there is none. */
  SourceLocation location() {
    return location;
  }
}
