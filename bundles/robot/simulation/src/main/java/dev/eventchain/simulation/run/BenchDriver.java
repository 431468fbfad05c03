package dev.eventchain.simulation.run;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.messages.CdrCodec;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.messages.MessageType;
import dev.eventchain.messages.MessageValue;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.bench.Bench.Consumed;
import dev.eventchain.simulation.bench.Bench.Effect;
import dev.eventchain.simulation.bench.Bench.Provided;
import dev.eventchain.simulation.bench.BenchRules;
import dev.eventchain.simulation.bench.TypedTopic;
import dev.eventchain.simulation.chain.ChainSignals;
import dev.eventchain.simulation.chain.SimulatedChain;
import dev.eventchain.simulation.fault.WorldFault;
import dev.eventchain.simulation.formula.SampledRun;
import dev.eventchain.simulation.formula.Signal;
import dev.eventchain.simulation.host.NodeSession;
import dev.eventchain.simulation.recording.Recording;
import dev.eventchain.simulation.scenario.Scenario;
import dev.eventchain.simulation.sensor.Lidar;
import dev.eventchain.simulation.world.Actuator;
import dev.eventchain.simulation.world.VehicleCommand;
import dev.eventchain.simulation.world.World;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.PriorityQueue;
import java.util.Set;

/**
 * Connects the nodes with a world in one scenario, as the bench defines: publishes the provided
 * topics when they are due, and turns messages on consumed topics into commands.
 */
final class BenchDriver {

  private static final TypedTopic CLOCK = new TypedTopic("/clock", "rosgraph_msgs/msg/Clock");

  private static final Set<Actuator> MOTION = Set.of(Actuator.SPEED, Actuator.YAW_RATE);

  /**
   * A measured message that has not arrived yet.
   *
   * @param arrival in ns
   * @param number sequence number of the measurement
   * @param publisher index of the topic
   * @param values its recorded values, in coherent units, by the names of the signals
   */
  private record Underway(
      long arrival, long number, int publisher, ByteBuffer bytes, Map<String, Double> values) {}

  /** A topic that is received. */
  private record Receiver(
      TypedTopic topic,
      MessageType type,
      List<Effect> effects,
      List<Signal> recorded,
      long lifetime) {}

  private final MessageCatalog catalog;
  private final SimulatedChain chain;
  private final Bench bench;
  private final Scenario scenario;
  private final ChainSignals chainSignals;
  private final Lidar lidar;
  private final WorldFault fault;
  private final RangeWatch ranges;
  private final OutputRecord outputs;
  private final List<Publisher> publishers = new ArrayList<>();
  private final List<Receiver> receivers = new ArrayList<>();
  private final Map<Actuator, Double> demands = new EnumMap<>(Actuator.class);
  private final PriorityQueue<Underway> underway =
      new PriorityQueue<>(
          Comparator.comparingLong(Underway::arrival).thenComparingLong(Underway::number));
  private final Kept kept;
  private long measured;
  private long epoch;

  /**
   * Creates a driver that publishes only the topics that nodes read, and always the clock.
   *
   * @param chain the topics that the nodes read and write
   * @param fault the fault in its messages
   * @param outputs receives the outputs of the components
   * @param kept receives the messages
   * @param recorded true to receive all topics of the nodes
   * @throws DiagnosticException (INPUT) {@code message.unknown} or {@code message.field.missing}: a
   *     message type is undefined, or does not fit the bench
   */
  BenchDriver(
      SimulatedChain chain,
      Scenario scenario,
      WorldFault fault,
      OutputRecord outputs,
      Kept kept,
      boolean recorded) {
    this.fault = fault;
    this.outputs = outputs;
    this.kept = kept;
    this.chain = chain;
    this.catalog = chain.catalog();
    this.bench = chain.bench();
    this.ranges = new RangeWatch(bench);
    this.scenario = scenario;
    this.chainSignals = chain.chainSignals();
    this.lidar = new Lidar(scenario.situation().ego().lidar(), scenario.seed());
    publishers.add(new Publisher(CLOCK, Optional.empty(), message(CLOCK), List.of(), 0));
    Set<String> read = chain.topicsRead();
    bench.provided().values().stream()
        .filter(topic -> read.contains(topic.topic()))
        .forEach(this::publish);
    Set<String> written = chain.topicsWritten();
    bench.consumed().values().stream()
        .filter(topic -> written.contains(topic.topic()))
        .forEach(this::receive);
    observe();
    chain.typedTopicsWritten().stream()
        .filter(topic -> recorded || kept.isOfAllTopics() || isRead(topic.name()))
        .forEach(this::observe);
  }

  private boolean isRead(String topic) {
    return outputs.reads(topic) || ranges.watches(topic);
  }

  private void publish(Provided provided) {
    TypedTopic topic = new TypedTopic(provided.topic(), provided.type());
    MessageValue message = message(topic);
    checked(topic, () -> constants(provided, message));
    publishers.add(
        new Publisher(
            topic, Optional.of(provided), message, recorded(provided.topic()), scenario.seed()));
  }

  private void receive(Consumed consumed) {
    TypedTopic topic = new TypedTopic(consumed.topic(), consumed.type());
    MessageType type = type(topic);
    checked(topic, () -> consumed.fields().forEach(it -> it.check(MessageValue.of(type))));
    // Fields that no component writes hold the default of their type, which is no demand.
    List<Effect> effects =
        consumed.fields().stream()
            .filter(it -> it.actuator().isPresent())
            .filter(it -> chain.isWritten(consumed.topic(), it.path()))
            .toList();
    add(topic, type, effects);
  }

  /** Subscribes to the topics between components that formulas read or reports show. */
  private void observe() {
    scenario.signals().stream()
        .flatMap(signal -> bench.signals().topicOf(signal).stream())
        .filter(topic -> chain.topicsWritten().contains(topic.name()))
        .forEach(topic -> observe(new TypedTopic(topic.name(), topic.type())));
    chainSignals.topics().stream()
        .filter(topic -> chain.topicsWritten().contains(topic.name()))
        .forEach(this::observe);
  }

  private void observe(TypedTopic topic) {
    if (receivers.stream().noneMatch(it -> it.topic().name().equals(topic.name()))) {
      add(topic, type(topic), List.of());
    }
  }

  private void add(TypedTopic topic, MessageType type, List<Effect> effects) {
    List<Signal> recorded = recorded(topic.name());
    long lifetime = chain.lifetime(topic.name());
    receivers.add(new Receiver(topic, type, effects, recorded, lifetime));
  }

  /** Returns the fields of a topic that formulas of the scenario read or reports show. */
  private List<Signal> recorded(String topic) {
    Map<String, Signal> recorded = new LinkedHashMap<>();
    chainSignals.on(topic).forEach(signal -> recorded.put(signal.name(), signal));
    scenario.signals().stream()
        .filter(it -> bench.signals().topicOf(it).filter(of -> of.name().equals(topic)).isPresent())
        .forEach(signal -> recorded.put(signal.name(), signal));
    return List.copyOf(recorded.values());
  }

  private MessageType type(TypedTopic topic) {
    return catalog
        .find(topic.type())
        .orElseThrow(
            () ->
                refused(
                    BenchRules.MESSAGE_UNKNOWN,
                    "The vehicle's topic " + topic.name() + " needs " + topic.type() + ".",
                    topic));
  }

  private MessageValue message(TypedTopic topic) {
    return MessageValue.of(type(topic));
  }

  private void constants(Provided provided, MessageValue message) {
    if (provided.lidar()) {
      Lidar.describe(message);
    }
    provided.scanner().ifPresent(it -> it.describe(message, 1.0 / provided.rate()));
    provided.objects().ifPresent(it -> it.clear(message));
    for (Bench.Field field : provided.fields()) {
      message.set(field.path(), field.source().example());
    }
  }

  /** Returns the published topics; the index of a message's topic is the position here. */
  List<TypedTopic> published() {
    return publishers.stream().map(Publisher::topic).toList();
  }

  /** Returns the received topics; the index of a message's topic is the position here. */
  List<TypedTopic> received() {
    return receivers.stream().map(Receiver::topic).toList();
  }

  /** Returns the frame of the lidar's messages; empty if there are none. */
  private String lidarFrame() {
    return publishers.stream()
        .filter(Publisher::isLidar)
        .map(it -> it.message().get("header.frame_id").toString())
        .findFirst()
        .orElse("");
  }

  /** Sets the time on clocks and stamps at time 0, in ns. */
  void startAt(long time) {
    epoch = time;
  }

  /** Returns the topics to record, once the time on the clocks is known. */
  Recording.Topics recorded() {
    return new Recording.Topics(published(), received(), lidarFrame(), epoch);
  }

  /** Returns the time of the next message, in ns, later than the last measurement. */
  long nextDue() {
    long due = publishers.stream().mapToLong(Publisher::due).min().orElseThrow();
    return underway.isEmpty() ? due : Math.min(due, underway.peek().arrival());
  }

  /** Returns the current messages of the sensors: one on each topic where one is due. */
  List<NodeSession.Inbound> sense(World world) {
    SampledRun moment = new SampledRun(world.moment());
    for (int i = 0; i < publishers.size(); i++) {
      if (publishers.get(i).due() <= world.now()) {
        measure(i, world, moment);
      }
    }
    List<NodeSession.Inbound> sensed = new ArrayList<>();
    while (!underway.isEmpty() && underway.peek().arrival() <= world.now()) {
      Underway message = underway.remove();
      Publisher publisher = publishers.get(message.publisher());
      String topic = publisher.topic().name();
      MessageType type = publisher.message().type();
      for (ByteBuffer bytes : fault.arriving(type, topic, world.now(), message.bytes())) {
        sensed.add(new NodeSession.Inbound(message.publisher(), bytes));
        message.values().forEach((name, it) -> world.trace().sample(name, world.now(), it));
        kept.samples()
            .ifPresent(it -> it.add(topic, world.now(), CdrCodec.decode(type, array(bytes))));
      }
    }
    return sensed;
  }

  private void measure(int index, World world, SampledRun moment) {
    Publisher publisher = publishers.get(index);
    long now = world.now();
    long shown = epoch + (publisher.isStamped() ? fault.stamp(now) : fault.clock(now));
    checked(publisher.topic(), () -> publisher.fill(world, moment, lidar, shown));
    if (!publisher.arrives(moment)) {
      world.trace().drop(publisher.topic().name());
      return;
    }
    if (fault.silences(publisher.topic().name(), now)) {
      return;
    }
    ranges.look(publisher.topic().name(), publisher.message(), now, world.trace());
    kept.coverage().ifPresent(it -> it.add(publisher.topic().name(), publisher.message()));
    underway.add(
        new Underway(
            world.now() + publisher.latency(),
            measured++,
            index,
            ByteBuffer.wrap(CdrCodec.encode(publisher.message())),
            values(publisher.recorded(), publisher.message())));
  }

  /** Receives a message of the nodes, which the vehicle follows from its publication on. */
  void take(NodeSession.Outbound outbound, World world) {
    Receiver receiver = receivers.get(outbound.topic());
    kept.log()
        .ifPresent(it -> it.add(outbound.time(), receiver.topic().name(), outbound.message()));
    if (receiver.effects().isEmpty()
        && receiver.recorded().isEmpty()
        && !kept.isOfContents()
        && !isRead(receiver.topic().name())) {
      return;
    }
    MessageValue message = CdrCodec.decode(receiver.type(), array(outbound.message()));
    outputs.add(receiver.topic().name(), message);
    ranges.look(receiver.topic().name(), message, outbound.time(), world.trace());
    kept.samples().ifPresent(it -> it.add(receiver.topic().name(), outbound.time(), message));
    kept.coverage().ifPresent(it -> it.add(receiver.topic().name(), message));
    expire(receiver, outbound.time(), world);
    values(receiver.recorded(), message)
        .forEach((name, it) -> world.trace().sample(name, outbound.time(), it));
    for (Effect effect : receiver.effects()) {
      demands.put(effect.actuator().get(), effect.demand(number(message, effect.path())));
    }
    if (!receiver.effects().isEmpty()) {
      boolean isRenewed =
          receiver.effects().stream()
              .anyMatch(effect -> effect.actuator().filter(MOTION::contains).isPresent());
      world.command(
          outbound.time(), VehicleCommand.of(demands, scenario.situation().ego(), isRenewed));
    }
  }

  private static byte[] array(ByteBuffer message) {
    byte[] bytes = new byte[message.remaining()];
    message.duplicate().get(bytes);
    return bytes;
  }

  /** Lets the values of all messages expire that are beyond their lifetime by now. */
  void expire(World world) {
    receivers.forEach(receiver -> expire(receiver, world.trace().end().time(), world));
  }

  private static void expire(Receiver receiver, long now, World world) {
    receiver
        .recorded()
        .forEach(signal -> world.trace().expire(signal.name(), now, receiver.lifetime()));
  }

  /** Returns the recorded fields of a message, in coherent units. */
  private static Map<String, Double> values(List<Signal> signals, MessageValue message) {
    Map<String, Double> values = new LinkedHashMap<>();
    for (Signal signal : signals) {
      double value =
          signal.named().isText()
              ? signal.named().numberOf(message.get(signal.field()).toString())
              : number(message, signal.field());
      values.put(signal.name(), signal.dimension().coherent(value));
    }
    return values;
  }

  /** Returns the value of a field; 1 or 0 for a Boolean. */
  private static double number(MessageValue message, String path) {
    return message.get(path) instanceof Boolean truth ? (truth ? 1.0 : 0.0) : message.number(path);
  }

  private void checked(TypedTopic topic, Runnable access) {
    try {
      access.run();
    } catch (IllegalArgumentException e) {
      throw refused(
          BenchRules.MESSAGE_FIELD_MISSING,
          "The vehicle's topic "
              + topic.name()
              + " needs "
              + topic.type()
              + " as the bench describes it: "
              + e.getMessage(),
          topic);
    }
  }

  /** Creates the exception for a message type, located in the file that defines it or should. */
  private DiagnosticException refused(Rule rule, String message, TypedTopic topic) {
    Optional<Path> file =
        catalog
            .file(topic.type())
            .or(
                () ->
                    catalog.folders().stream()
                        .map(folder -> folder.resolve(topic.type() + ".msg"))
                        .findFirst());
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT,
        Diagnostic.of(rule, message, file.map(SourceLocation::of).orElse(SourceLocation.NONE))
            .withHint("Put the definition into software-base/msg/PACKAGE/msg/NAME.msg."));
  }
}
