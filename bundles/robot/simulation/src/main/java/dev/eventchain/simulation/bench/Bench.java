package dev.eventchain.simulation.bench;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageValue;
import dev.eventchain.messages.Unit;
import dev.eventchain.model.eventchain.EventChain;
import dev.eventchain.simulation.formula.Formula;
import dev.eventchain.simulation.formula.SampledRun;
import dev.eventchain.simulation.formula.Signal;
import dev.eventchain.simulation.formula.Term;
import dev.eventchain.simulation.sensor.ObjectSensor;
import dev.eventchain.simulation.world.Actuator;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.function.Function;
import java.util.stream.Stream;
import org.eclipse.emf.ecore.EObject;

/**
 * How the simulated road and the software are connected: where the fields of each topic that the
 * vehicle provides come from, and what the fields of each topic that it consumes do. Read from
 * {@code bench.yaml}; a project without one has the topics of the CARLA ROS bridge. Immutable.
 */
public final class Bench {

  /** What the file is called, in the folder of a project. */
  public static final String FILE = "bench.yaml";

  /** Where a value that is published comes from. */
  public sealed interface Source permits Constant, Quantity, Truth {

    /** A value of the kind that is published. */
    Object example();

    /** What the value depends on. */
    default Set<Signal> signals() {
      return Set.of();
    }
  }

  /** Always the same, as {@link dev.eventchain.messages.MessageValue} takes it. */
  record Constant(Object value) implements Source {

    @Override
    public Object example() {
      return value;
    }
  }

  /**
   * A quantity of the world.
   *
   * @param text as it is written
   * @param unit that of the field
   * @param absent what is published while it has no value
   * @param noise standard deviation of what is published, in the field's unit
   */
  public record Quantity(String text, Term term, Unit unit, double absent, double noise)
      implements Source {

    /**
     * The value in the field's unit.
     *
     * @param random where the noise comes from; not asked if there is none
     */
    public double at(SampledRun moment, SplittableRandom random) {
      double value = term.values().in(moment).applyAsDouble(0);
      if (Double.isNaN(value)) {
        return absent;
      }
      return unit.ofCoherent(value) + (noise > 0.0 ? noise * random.nextGaussian() : 0.0);
    }

    /** The same with noise. */
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

  /** True or false. */
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

  /** A field that is published. */
  public record Field(String path, Source source, SourceLocation location) {}

  /**
   * A topic that the vehicle provides.
   *
   * @param type the full name of the message type
   * @param rate in Hz
   * @param lidar whether its messages are the scans of the roof lidar
   * @param objects what its messages say of the objects ahead
   * @param transfer how its messages get to the nodes
   */
  public record Provided(
      String topic,
      String type,
      double rate,
      boolean lidar,
      Optional<ObjectSensor> objects,
      List<Field> fields,
      Transfer transfer,
      SourceLocation location) {

    /** In ns. */
    public long period() {
      return Math.round(1e9 / rate);
    }

    /** The fields of its messages that get values; all those of a lidar do. */
    Stream<String> paths() {
      return Stream.concat(
          fields.stream().map(Field::path),
          objects.stream().flatMap(it -> it.columns().stream()).map(ObjectSensor.Column::path));
    }
  }

  /**
   * How messages get to the nodes.
   *
   * @param latency from the moment that a message is about to that at which it arrives, in ns
   * @param lost the part of the messages that never arrive, 0 to 1; empty for none
   */
  public record Transfer(long latency, Optional<Term> lost) {

    /** Whether a message is lost. */
    public boolean loses(SampledRun moment, SplittableRandom random) {
      return lost.isPresent()
          && random.nextDouble() < lost.get().values().in(moment).applyAsDouble(0);
    }

    Set<Signal> signals() {
      return lost.map(Term::signals).orElse(Set.of());
    }
  }

  /**
   * What a field does that the vehicle consumes.
   *
   * @param actuator empty if it is only observed
   * @param unit that of the field
   * @param required whether the software must write it
   */
  public record Effect(
      String path,
      Optional<Actuator> actuator,
      String unit,
      boolean required,
      SourceLocation location) {

    /**
     * Whether a message has the field, of the kind that the actuator needs.
     *
     * @throws IllegalArgumentException says what is wrong
     */
    public void check(MessageValue message) {
      boolean isTruth = message.get(path) instanceof Boolean;
      if (actuator.isPresent() && actuator.get().truth() != isTruth) {
        throw new IllegalArgumentException(
            "'%s' cannot drive %s.".formatted(path, actuator.get().id()));
      }
    }

    /** What a number of the field asks of the actuator, in the actuator's unit. */
    public double demand(double value) {
      double coherent = Unit.parse(unit).orElseThrow().coherent(value);
      return actuator.orElseThrow().unit().ofCoherent(coherent);
    }
  }

  /** A topic that the vehicle consumes. */
  public record Consumed(String topic, String type, List<Effect> fields, SourceLocation location) {

    /** Whether it does anything to the vehicle. */
    public boolean commands() {
      return fields.stream().anyMatch(field -> field.actuator().isPresent());
    }
  }

  private final Map<String, Provided> provided;
  private final Map<String, Consumed> consumed;
  private final Set<String> own;
  private final BenchSignals signals;
  private final DeclaredSignals declared;
  private final SourceLocation location;

  Bench(
      Map<String, Provided> provided,
      Map<String, Consumed> consumed,
      Set<String> own,
      BenchSignals signals,
      DeclaredSignals declared,
      SourceLocation location) {
    this.provided = provided;
    this.consumed = consumed;
    this.own = Set.copyOf(own);
    this.signals = signals;
    this.declared = declared;
    this.location = location;
  }

  /**
   * Reads a bench.
   *
   * @param file {@code bench.yaml}; empty if the project has none
   * @param declared the project's signals
   * @param messages where the types of the topics are defined
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

  /** The topics of the CARLA ROS bridge, for software whose signals are not known. */
  public static Bench carla() {
    return read(Optional.empty(), List.of(), MessageCatalog.of(List.of()));
  }

  /**
   * Whether a chain fits the bench: each topic that it reads from the vehicle has a source, and so
   * has each field; each topic that it writes to the vehicle is taken, and each required field
   * written.
   *
   * @param locator the places of the chain's elements
   * @return {@code bench.topic.unconnected}, {@code bench.field.unset}, {@code
   *     bench.field.unwritten}, {@code bench.type}, {@code bench.unit}
   */
  public List<Diagnostic> check(EventChain chain, Function<EObject, SourceLocation> locator) {
    return new BenchCheck(this, chain, locator).check();
  }

  /**
   * What the world provides and takes, and how a project is connected with it, for people.
   *
   * @param chain the project's chain, if there is one
   */
  public String listing(Optional<EventChain> chain) {
    return new BenchListing(this, chain).text();
  }

  /**
   * A file {@code bench.yaml} for a project that has none: what can be told from names and units is
   * connected, the rest stands in comments.
   */
  public static String proposal(
      List<dev.eventchain.model.Signal> declared, MessageCatalog messages) {
    return new BenchProposal(declared, messages).text();
  }

  /** The JSON Schema of {@code bench.yaml}. */
  public static String schema() {
    return BenchReader.resource("bench.schema.json");
  }

  /** The topics that the vehicle provides, by their full names. */
  public Map<String, Provided> provided() {
    return provided;
  }

  /** The topics that the vehicle consumes, by their full names. */
  public Map<String, Consumed> consumed() {
    return consumed;
  }

  /** Whether what is sent depends on an input. */
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

  /** What formulas may read. */
  public BenchSignals signals() {
    return signals;
  }

  /**
   * Whether the project speaks of a topic: in its own bench, or in its signals. One that speaks of
   * none may mean any.
   */
  public boolean isOwn(String topic) {
    boolean nothingSaid = own.isEmpty() && declared.isEmpty();
    return nothingSaid || own.contains(topic) || declared.find(topic).isPresent();
  }

  DeclaredSignals declared() {
    return declared;
  }

  /** The file; nothing if there is none. */
  SourceLocation location() {
    return location;
  }
}
